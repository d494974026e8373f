#pragma once
#include <pthread.h>

#include <memory>
#include <new>

namespace plumbline {

/// One object for each thread, made when the thread first asks for it and destroyed when the thread ends;
/// that of the main thread lives as long as the program. Where memory is short this throws std::bad_alloc.
/// With thread_local, glibc ends the program if it has no memory to register the destructor.
template <class T>
class ThreadObject {
public:
  ThreadObject() {
    const auto destroy = [](void* object) { delete static_cast<T*>(object); };
    if (pthread_key_create(&key_, destroy) != 0) throw std::bad_alloc();
  }
  ThreadObject(const ThreadObject&) = delete;
  ThreadObject& operator=(const ThreadObject&) = delete;

  T& get() {
    if (void* object = pthread_getspecific(key_)) return *static_cast<T*>(object);
    auto made = std::make_unique<T>();
    if (pthread_setspecific(key_, made.get()) != 0) throw std::bad_alloc();
    return *made.release();
  }

private:
  // Never deleted: threads may outlast static objects, and modules log until the very end.
  pthread_key_t key_{};
};

}  // namespace plumbline
