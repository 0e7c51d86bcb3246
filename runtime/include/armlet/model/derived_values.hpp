#pragma once

#include <memory>
#include <type_traits>

namespace armlet {

// Values that are computed once from a constant source: at most one of each type. Copies share
// them. Thread-safe.
class DerivedValues {
 public:
  DerivedValues();

  // The value of type T. T(source) is constructed in the first call, by whichever thread makes it;
  // other threads wait. The value lives as long as the last copy of this object.
  //
  // source  the same in each call; T must not keep a reference to it. The constructor of T may ask
  //         for values of other types.
  // throws  what the constructor throws; the next call tries again.
  template <class T, class Source>
  const T& get(const Source& source) const {
    static_assert(std::is_object_v<T> && std::is_same_v<T, std::remove_cv_t<T>>);
    const auto make = [](const void* from) -> std::shared_ptr<const void> {
      return std::make_shared<const T>(*static_cast<const Source*>(from));
    };
    return *static_cast<const T*>(find(&kKey<T>, make, &source));
  }

 private:
  // A key for the type: the address of this variable.
  template <class T>
  static constexpr char kKey = 0;

  using Make = std::shared_ptr<const void>(const void* source);
  const void* find(const void* key, Make* make, const void* source) const;

  struct Slots;
  std::shared_ptr<Slots> slots_;  // of all copies
};

}  // namespace armlet
