package org.pendant.script.vm;

import java.util.List;

/**
 * Program event: something that happened to a program in a frame; a short one starts and ends in
 * the same.
 */
public sealed interface ProgramEvent {
  /** The name on its {@code def} or {@code sec} line. */
  String name();

  /**
   * The primary program has started.
   *
   * @param labels those in its text that have a number, by their lines
   */
  record Started(String name, List<ProgramLabel> labels) implements ProgramEvent {
    public Started {
      labels = List.copyOf(labels);
    }

    /** One without labels. */
    public Started(String name) {
      this(name, List.of());
    }
  }

  /** The primary program has ended. */
  record Ended(String name, Ending ending) implements ProgramEvent {}

  /** A secondary program has failed. */
  record SecondaryFailed(String name, ScriptFailure failure) implements ProgramEvent {}
}
