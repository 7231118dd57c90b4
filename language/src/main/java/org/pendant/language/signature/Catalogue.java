package org.pendant.language.signature;

import java.util.Collection;
import java.util.Optional;

/** Catalogue of every function and method that a program may call without defining it. */
public interface Catalogue {

  /** The function called {@code name}. */
  Optional<Signature> function(String name);

  /** The method {@code name} of values of {@code receiver} (list, matrix, struct). */
  Optional<Signature> method(Type receiver, String name);

  /** Functions and methods, in the order of their declaration. */
  Collection<Signature> all();
}
