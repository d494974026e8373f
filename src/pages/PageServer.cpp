#include "pages/PageServer.h"

#include <arpa/inet.h>
#include <libwebsockets.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "framework/Loopback.h"
#include "pages/Visitors.h"

namespace plumbline::pages {

namespace {

constexpr std::size_t maxPages = 64;
constexpr std::size_t maxVisitors = 128;  ///< beyond them silent connections give way
constexpr const char* protocolName = "plumbline";

/// A page's connection.
struct Session {
  std::unique_ptr<PageSession> page;
  std::string received, sending;
};

std::string header(lws* wsi, lws_token_indexes token) {
  std::array<char, 512> text{};
  const int length = lws_hdr_copy(wsi, text.data(), static_cast<int>(text.size()), token);
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : std::string();
}

bool isLoopbackHost(std::string_view host) {
  if (const auto colon = host.rfind(':'); colon != std::string_view::npos && host.back() != ']')
    host = host.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) return host == "[::1]";
  return host != "::1" && isLoopbackAddress(host);
}

/// Where libwebsockets has no memory for a part of its context it may go on without, and die of that later.
std::atomic<bool> lacksMemory = false;
void* reallocate(void* old, std::size_t size, const char*) {
  if (size == 0) {
    std::free(old);
    return nullptr;
  }
  void* made = std::realloc(old, size);
  if (made == nullptr) lacksMemory = true;
  return made;
}

bool hasSent(lws* wsi) {
  char byte = 0;
  return recv(lws_get_socket_fd(wsi), &byte, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
}

/// Whether the port is free: asked first, as libwebsockets 4.1.6 loses memory where it can't bind. True too
/// for what is no IPv4 address (an interface's name), which only the library knows.
bool canListen(const std::string& address, int port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1) return true;
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  const int yes = 1;
  setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool free =
      bind(fd, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 && listen(fd, 1) == 0;
  close(fd);
  return free;
}

}  // namespace

struct PageServer::Implementation {
  Implementation(const Config& config, PageSource& source);
  ~Implementation();

  /// Sets context and port, or leaves both unset.
  void open(lws_context_creation_info info);
  bool admits(lws* wsi) const;
  void receive(Session& session, lws* wsi, std::string_view bytes);
  /// Sends at most one message; whatever is waiting comes when the page has taken it.
  bool sendNext(Session& session, lws* wsi);
  /// Closes silent connections where there are too many.
  void makeRoom();
  /// Of every connection: when it comes, asks for something, goes.
  void follow(lws* wsi, lws_callback_reasons reason);
  int serve(lws* wsi, lws_callback_reasons reason, void* user, void* bytes, std::size_t size);
  static int callback(lws* wsi, lws_callback_reasons reason, void* user, void* bytes, std::size_t size);
  static int httpCallback(lws* wsi, lws_callback_reasons reason, void* user, void* bytes, std::size_t size);
  static Implementation* of(lws* wsi);

  Config config;
  PageSource& source;
  std::array<lws_protocols, 3> protocols{};
  lws_http_mount mount{};
  lws_context* context = nullptr;
  int port = 0;
  std::size_t pages = 0;
  Visitors visitors{maxVisitors};
  std::atomic<bool> stopping = false;
  std::thread thread;
};

PageServer::Implementation::Implementation(const Config& given, PageSource& source)
    : config(given), source(source) {
  if (config.address == "localhost") config.address = "127.0.0.1";
  protocols[0].name = "http";
  protocols[0].callback = httpCallback;
  protocols[1].name = protocolName;
  protocols[1].callback = callback;
  protocols[1].per_session_data_size = sizeof(Session*);
  protocols[1].rx_buffer_size = std::min<std::size_t>(source.maxMessage(), 16384);

  mount.mountpoint = "/";
  mount.mountpoint_len = 1;
  mount.origin = config.folder.c_str();
  mount.def = config.index.c_str();
  mount.origin_protocol = LWSMPRO_FILE;
  mount.cache_max_age = 0;

  lws_set_log_level(0, nullptr);
  lws_context_creation_info info{};
  info.port = config.port;
  info.iface = config.address.c_str();
  info.protocols = protocols.data();
  info.mounts = &mount;
  info.user = this;
  info.fd_limit_per_thread = 2 * maxVisitors;  // a burst, until the silent ones are closed
  info.gid = info.uid = static_cast<unsigned>(-1);
  info.options = LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND | LWS_SERVER_OPTION_DISABLE_IPV6 |
                 LWS_SERVER_OPTION_HTTP_HEADERS_SECURITY_BEST_PRACTICES_ENFORCE;
  open(info);
  if (port <= 0 && config.anyPort) {
    info.port = 0;
    open(info);
  }
  if (port <= 0) {
    throw std::runtime_error("cannot listen on " + config.address + ':' + std::to_string(config.port) +
                             " for the page; is the port in use? Choose another or 0");
  }
  source.onNews([this] { lws_cancel_service(context); });
}

void PageServer::Implementation::open(lws_context_creation_info info) {
  if (!canListen(config.address, info.port)) return;
  lws_set_allocator(reallocate);
  lacksMemory = false;
  context = lws_create_context(&info);
  if (lacksMemory) throw std::bad_alloc();  // a context that was half made is not safe to destroy
  lws_vhost* host = context ? lws_get_vhost_by_name(context, "default") : nullptr;
  port = host ? lws_get_vhost_listen_port(host) : 0;
  if (port > 0) return;
  if (context) lws_context_destroy(context);
  context = nullptr;
}

PageServer::Implementation::~Implementation() {
  source.onNews({});
  lws_context_destroy(context);
}

bool PageServer::Implementation::admits(lws* wsi) const {
  if (pages >= maxPages) return false;
  const std::string host = header(wsi, WSI_TOKEN_HOST);
  const std::string origin = header(wsi, WSI_TOKEN_ORIGIN);
  if (!origin.empty() && origin != "http://" + host && origin != "https://" + host) return false;
  if (config.token.empty()) return isLoopbackHost(host);
  std::array<char, 256> given{};
  const char* found = lws_get_urlarg_by_name(wsi, "token=", given.data(), static_cast<int>(given.size()));
  return found && sameSecret(found, config.token);
}

void PageServer::Implementation::receive(Session& session, lws* wsi, std::string_view bytes) {
  if (session.received.size() + bytes.size() > source.maxMessage()) {
    session.received.clear();
    return lws_set_timeout(wsi, PENDING_TIMEOUT_CLOSE_SEND, LWS_TO_KILL_ASYNC);
  }
  session.received += bytes;
  if (!lws_is_final_fragment(wsi) || lws_remaining_packet_payload(wsi) != 0) return;
  if (!session.page->receive(session.received))
    lws_set_timeout(wsi, PENDING_TIMEOUT_CLOSE_SEND, LWS_TO_KILL_ASYNC);
  session.received.clear();
}

bool PageServer::Implementation::sendNext(Session& session, lws* wsi) {
  session.sending.assign(LWS_PRE, '\0');
  const PageSession::Kind kind = session.page->next(session.sending);
  if (kind == PageSession::Kind::end) return false;
  if (kind == PageSession::Kind::nothing) return true;
  auto* bytes = reinterpret_cast<unsigned char*>(session.sending.data()) + LWS_PRE;
  const bool binary = kind == PageSession::Kind::binary;
  if (lws_write(wsi, bytes, session.sending.size() - LWS_PRE, binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT) < 0)
    return false;
  lws_callback_on_writable(wsi);
  return true;
}

void PageServer::Implementation::makeRoom() {
  while (lws* silent = visitors.toClose(hasSent))
    lws_set_timeout(silent, PENDING_TIMEOUT_CLOSE_SEND, LWS_TO_KILL_ASYNC);
}

void PageServer::Implementation::follow(lws* wsi, lws_callback_reasons reason) {
  if (reason == LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED) {
    visitors.add(wsi);
    makeRoom();
  } else if (reason == LWS_CALLBACK_FILTER_HTTP_CONNECTION ||
             reason == LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION) {
    visitors.asked(wsi);
  } else if (reason == LWS_CALLBACK_WSI_DESTROY) {
    visitors.remove(wsi);
  }
}

int PageServer::Implementation::serve(lws* wsi, lws_callback_reasons reason, void* user, void* bytes,
                                      std::size_t size) {
  auto** session = static_cast<Session**>(user);
  switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
      return admits(wsi) ? 0 : 1;
    case LWS_CALLBACK_ESTABLISHED:
      *session = new Session{source.open(), {}, {}};
      ++pages;
      if (!(*session)->page) return -1;
      lws_callback_on_writable(wsi);
      return 0;
    case LWS_CALLBACK_CLOSED:
      if (*session) --pages;
      delete *session;
      *session = nullptr;
      return 0;
    case LWS_CALLBACK_RECEIVE:
      receive(**session, wsi, std::string_view(static_cast<const char*>(bytes), size));
      return 0;
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return sendNext(**session, wsi) ? 0 : -1;
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
      lws_callback_on_writable_all_protocol(context, &protocols[1]);
      return 0;
    default:
      return 0;
  }
}

int PageServer::Implementation::callback(lws* wsi, lws_callback_reasons reason, void* user, void* bytes,
                                         std::size_t size) {
  Implementation* self = of(wsi);
  if (!self) return 0;
  self->follow(wsi, reason);
  return self->serve(wsi, reason, user, bytes, size);
}

int PageServer::Implementation::httpCallback(lws* wsi, lws_callback_reasons reason, void* user, void* bytes,
                                             std::size_t size) {
  if (Implementation* self = of(wsi)) self->follow(wsi, reason);
  return lws_callback_http_dummy(wsi, reason, user, bytes, size);
}

/// Null while the context is being made or unmade: then there is nothing to do.
PageServer::Implementation* PageServer::Implementation::of(lws* wsi) {
  lws_context* context = lws_get_context(wsi);
  auto* self = context ? static_cast<Implementation*>(lws_context_user(context)) : nullptr;
  return self && self->context ? self : nullptr;
}

PageServer::PageServer(const Config& config, PageSource& source)
    : implementation_(std::make_unique<Implementation>(config, source)) {}

PageServer::~PageServer() { stop(); }

void PageServer::start() {
  implementation_->thread = std::thread([self = implementation_.get()] {
    // What has come since may have been half a request, and when there is no place left nobody comes.
    while (!self->stopping && lws_service(self->context, 0) >= 0) self->makeRoom();
  });
}

void PageServer::stop() {
  implementation_->stopping = true;
  lws_cancel_service(implementation_->context);
  if (implementation_->thread.joinable()) implementation_->thread.join();
}

int PageServer::port() const { return implementation_->port; }

}  // namespace plumbline::pages
