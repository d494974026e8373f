// Fast DDS 2.9 deletes readers through a base class of another size, which is its own business: the address
// sanitizer asks this program for its options at the start.
extern "C" const char*
__asan_default_options();  // NOLINT(bugprone-reserved-identifier): the sanitizer's name
extern "C" const char* __asan_default_options() { return "new_delete_type_mismatch=0"; }  // NOLINT
