package org.pendant.language.check;

/** Binding: what a variable's name stands for at one place of a program (manual 9). */
public sealed interface Binding {

  String name();

  /** A variable of the whole program. */
  record Global(String name) implements Binding {}

  /** A variable of one call of one function or of one run of one thread. */
  record Local(String name) implements Binding {}
}
