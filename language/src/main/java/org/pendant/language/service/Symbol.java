package org.pendant.language.service;

/**
 * Symbol: what a name in the text stands for; two occurrences mean the same if their symbols are
 * equal.
 */
public sealed interface Symbol {

  /** The name as it is written. */
  String name();

  /** A variable of the whole program (manual 9). */
  record Global(String name) implements Symbol {}

  /**
   * A variable of one function or thread.
   *
   * @param owner offset of the name in the head of the definition that it belongs to
   */
  record Local(String name, int owner) implements Symbol {}

  /**
   * A parameter of one function.
   *
   * @param owner offset of the name in the head of its definition
   */
  record Parameter(String name, int owner) implements Symbol {}

  /**
   * A function, thread or secondary program of this text.
   *
   * @param definedAt offset of its name in the head of its definition
   */
  record Function(String name, int definedAt) implements Symbol {}

  /** A function of the catalogue, and {@code struct}. */
  record Builtin(String name) implements Symbol {}

  /** The name in {@code name = value} in a call of a built-in function. */
  record NamedArgument(String function, String name) implements Symbol {}

  /** A method after a dot; receivers are not told apart. */
  record Method(String name) implements Symbol {}

  /** A member of some struct; structs are not told apart. */
  record Member(String name) implements Symbol {}

  /** A name that nothing assigns or defines. */
  record Unknown(String name) implements Symbol {}
}
