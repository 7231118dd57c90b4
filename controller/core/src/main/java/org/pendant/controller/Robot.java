package org.pendant.controller;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.InterpreterJournal;
import org.pendant.script.vm.LoadResult;

/** Robot as its clients see it: they read its state and ask it for something, from any thread. */
public interface Robot {
  /** The newest snapshot. */
  ControllerState state();

  /** Every snapshot in turn, for who must not miss a frame. */
  StateStream feed();

  /**
   * Has a command carried out, and waits for the reply. While too many other commands wait it waits
   * for a place among them, unless there is no deadline.
   *
   * @return {@link Reply.Busy} when the deadline has passed, and when the calling thread is
   *     interrupted, which it stays then
   */
  Reply ask(Command command, Deadline deadline);

  /**
   * Leaves a command for the next frame. What is chained to the reply without an executor runs in
   * the frame loop and must be short.
   */
  CompletableFuture<Reply> submit(Command command);

  /** As {@link #submit}, for who may want to take the command back. */
  PendingCommand post(Command command);

  /** Parses, checks and compiles a program. */
  LoadResult load(Source source);

  /** The functions that programs may call. */
  Builtins<ControlBox> builtins();

  /**
   * What is set up, with the values that programs have left in the installation's variables. The
   * same object while nothing of it changes.
   */
  Installation installation();

  /** The limits and planes that hold. */
  SafetyConfiguration safety();

  /**
   * Log lines after number {@code number} that are still kept, oldest first. The number of the
   * first tells how many were missed.
   */
  List<LogEntry> logSince(long number);

  /** What has happened in interpreter mode. */
  InterpreterJournal interpreterJournal();

  /** Whether what has happened can happen once more, with the same options and commands. */
  Determinism determinism();
}
