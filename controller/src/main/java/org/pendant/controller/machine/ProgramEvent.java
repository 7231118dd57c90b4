package org.pendant.controller.machine;

/** Something that happened to a program in a frame; a short one starts and ends in the same. */
public sealed interface ProgramEvent {
  /** The name on its {@code def} or {@code sec} line. */
  String name();

  /** The primary program has started. */
  record Started(String name) implements ProgramEvent {}

  /** The primary program has ended. */
  record Ended(String name, Ending ending) implements ProgramEvent {}

  /** A secondary program has failed. */
  record SecondaryFailed(String name, ScriptFailure failure) implements ProgramEvent {}
}
