package org.pendant.language.service;

import java.util.function.Supplier;

/** Deferred: a value that is made once, when it is asked for; for any thread. */
final class Deferred<T> {
  private final Supplier<T> maker;
  private T value;

  Deferred(Supplier<T> maker) {
    this.maker = maker;
  }

  synchronized T get() {
    if (value == null) {
      value = maker.get();
    }
    return value;
  }
}
