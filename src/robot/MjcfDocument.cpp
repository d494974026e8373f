#include "robot/MjcfDocument.h"

#include "framework/ReadFile.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;

constexpr int deepestFile = 16;  // files within each other
constexpr std::size_t mostFiles = 64;
constexpr std::size_t mostText = 4 << 20;  // of all files

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

/// Whether a file is in a folder or in one within it, links followed.
bool isWithin(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path way =
      fs::weakly_canonical(file, error).lexically_relative(fs::weakly_canonical(folder, error));
  return !way.empty() && *way.begin() != "..";
}

std::vector<std::string> modelsIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".xml" && names.size() < 1000)
      names.push_back(at->path().filename().string());
  return names;
}

}  // namespace

MjcfDocument::MjcfDocument(const std::string& text, const std::string& mainFile) : XmlElements(mainFile) {
  parse(text, file, document_);
  root_ = document_.FirstChildElement("mujoco");
  if (!root_) failMechanism(file, "no <mujoco>; give a model of MuJoCo");
  std::error_code error;
  read_.insert(fs::weakly_canonical(file, error));
  size_ = text.size();
  expand(*root_, file, 0);
}

void MjcfDocument::parse(const std::string& text, const std::string& of,
                         tinyxml2::XMLDocument& document) const {
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    failMechanism(of + ":" + std::to_string(document.ErrorLineNum()),
                  std::string("broken XML (") + document.ErrorName() + ")");
}

std::string MjcfDocument::placeIn(const std::string& of, const XMLElement& e) const {
  return e.GetUserData() ? placeOf(e) : of + ":" + std::to_string(e.GetLineNum());
}

void MjcfDocument::expand(XMLElement& parent, const std::string& of, int depth) {
  for (XMLElement* e = parent.FirstChildElement(); e;) {
    XMLElement* const next = e->NextSiblingElement();
    if (std::string_view(e->Name()) == "include")
      replace(*e, of, depth);
    else
      expand(*e, of, depth);
    e = next;
  }
}

void MjcfDocument::replace(XMLElement& include, const std::string& of, int depth) {
  const std::string place = placeIn(of, include);
  const fs::path path = find(include, of);
  std::error_code error;
  if (depth == deepestFile)
    failMechanism(place, "files are included too deeply, more than 16 within each other");
  if (!read_.insert(fs::weakly_canonical(path, error)).second)
    failMechanism(place, "<include> names " + path.string() + " a second time; include it once");
  if (read_.size() > mostFiles) failMechanism(place, "more than 64 files are included");
  tinyxml2::XMLDocument part;
  try {
    const std::string text = readFile(path.string(), mostText);
    size_ += text.size();
    if (size_ > mostText) failMechanism(place, "all files together are longer than 4 MiB");
    parse(text, path.string(), part);
  } catch (const FileProblem& problem) {
    failMechanism(path.string(), problem.what());
  }
  XMLElement* const root = part.RootElement();
  if (!root) failMechanism(path.string(), "no element; what is included has one around all others");
  expand(*root, path.string(), depth + 1);
  tinyxml2::XMLNode* parent = include.Parent();
  tinyxml2::XMLNode* last = &include;
  for (const XMLElement* e = root->FirstChildElement(); e; e = e->NextSiblingElement())
    last = parent->InsertAfterChild(last, copyInto(*include.GetDocument(), *e, path.string()));
  parent->DeleteChild(&include);
}

fs::path MjcfDocument::find(const XMLElement& include, const std::string& of) const {
  const std::string place = placeIn(of, include);
  const char* name = include.Attribute("file");
  if (!name || !*name) failMechanism(place, "<include> lacks file=\"...\"");
  const fs::path folder = folderOf(file);
  std::error_code error;
  const std::string shown = std::string(name).substr(0, 200);
  // Versions of MuJoCo differ in which of the two folders counts.
  const fs::path own = folderOf(of) / name, mains = folder / name;
  if (!isWithin(own, folder))
    failMechanism(place, "<include> names " + shown +
                             ", which is outside the model's folder; copy it into that, or save the whole "
                             "model with MuJoCo (mj_saveLastXML)");
  const bool isOwn = fs::is_regular_file(own, error),
             isMains = isWithin(mains, folder) && fs::is_regular_file(mains, error);
  if (isOwn && isMains && !fs::equivalent(own, mains, error))
    failMechanism(place, "<include> names " + shown +
                             ", which is in this file's folder and in the main file's; rename one");
  if (isOwn) return own;
  if (isMains) return mains;
  failMechanism(place, "<include> names " + shown + ", which does not exist" +
                           suggestion(name, modelsIn(folderOf(of))));
}

XMLElement* MjcfDocument::copyInto(tinyxml2::XMLDocument& document, const XMLElement& e,
                                   const std::string& of) {
  XMLElement* const made = e.ShallowClone(&document)->ToElement();
  const auto* const from = static_cast<const XmlPlace*>(e.GetUserData());
  made->SetUserData(&places_.emplace_back(from ? *from : XmlPlace{of, e.GetLineNum()}));
  for (const XMLElement* c = e.FirstChildElement(); c; c = c->NextSiblingElement())
    made->InsertEndChild(copyInto(document, *c, of));
  return made;
}

}  // namespace plumbline
