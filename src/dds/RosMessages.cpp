#include "dds/RosMessages.h"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <cmath>
#include <cstdint>

namespace plumbline::dds::ros {
namespace {

/// CDR of one message, little endian, members one after another, each aligned to its size.
class Writer {
public:
  Writer() : cdr_(buffer_, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS, eprosima::fastcdr::Cdr::DDS_CDR) {}

  void operator()(double value) { cdr_ << value; }
  void operator()(const std::string& value) { cdr_ << value; }
  void operator()(const Vector& value) { all(value.x, value.y, value.z); }
  void operator()(const Quaternion& value) { all(value.x, value.y, value.z, value.w); }
  void operator()(const std::array<double, 9>& value) { cdr_ << value; }
  void operator()(const std::vector<double>& value) { cdr_ << value; }
  void operator()(const std::vector<std::string>& value) { cdr_ << value; }
  void operator()(const Header& header) {
    constexpr double nanoseconds = 1e9;
    const double whole = std::floor(header.time);
    cdr_ << static_cast<std::int32_t>(whole)
         << static_cast<std::uint32_t>((header.time - whole) * nanoseconds);
    cdr_ << header.frame;
  }
  void operator()(const Transform& transform) {
    all(transform.header, transform.childFrame, transform.translation, transform.rotation);
  }
  void noCovariance() { cdr_ << std::array<double, 36>{}; }
  void size(std::size_t count) { cdr_ << static_cast<std::uint32_t>(count); }

  template <typename... Values>
  void all(const Values&... values) {
    ((*this)(values), ...);
  }

  std::string bytes() { return {buffer_.getBuffer(), cdr_.getSerializedDataLength()}; }

private:
  eprosima::fastcdr::FastBuffer buffer_;
  eprosima::fastcdr::Cdr cdr_;
};

template <typename... Values>
std::string encoded(const Values&... values) {
  Writer writer;
  writer.all(values...);
  return writer.bytes();
}

}  // namespace

std::string encode(const JointState& m) {
  return encoded(m.header, m.names, m.positions, m.velocities, m.efforts);
}

std::string encode(const Imu& m) {
  return encoded(m.header, m.orientation, m.orientationCovariance, m.angularVelocity,
                 m.angularVelocityCovariance, m.linearAcceleration, m.linearAccelerationCovariance);
}

std::string encode(const Odometry& m) {
  Writer writer;
  writer.all(m.header, m.childFrame, m.position, m.orientation);
  writer.noCovariance();
  writer.all(m.linear, m.angular);
  writer.noCovariance();
  return writer.bytes();
}

std::string encode(const std::vector<Transform>& transforms) {
  Writer writer;
  writer.size(transforms.size());
  for (const Transform& transform : transforms) writer(transform);
  return writer.bytes();
}

std::string encode(const PointStamped& m) { return encoded(m.header, m.point); }

std::string encode(const std::string& text) { return encoded(text); }

TopicName topicName(const std::string& topic, const std::string& package, const std::string& message,
                    bool lasting) {
  TopicName name{"rt/" + topic, package + "::msg::dds_::" + message + "_", true};
  name.reliable = true;
  name.lasting = lasting;
  return name;
}

}  // namespace plumbline::dds::ros
