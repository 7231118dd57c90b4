package org.pendant.script.vm;

/** Ending: how a program came to its end. */
public sealed interface Ending {

  /** The main level ran past its last statement, or returned. */
  record Finished() implements Ending {}

  /** A {@code halt} was executed. */
  record Halted() implements Ending {}

  /** It was stopped from outside: a button, a command, a safety stop. */
  record Stopped() implements Ending {}

  /** A runtime error. */
  record Failed(ScriptFailure failure) implements Ending {}
}
