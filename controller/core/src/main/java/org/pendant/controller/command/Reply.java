package org.pendant.controller.command;

import java.util.Optional;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Interpreter;
import org.pendant.script.vm.InterpreterStatus;
import org.pendant.script.vm.ScriptFailure;

/** Answer to a {@link Command}, given when what it has done can be seen in the newest snapshot. */
public sealed interface Reply {
  /** Carried out. */
  record Done() implements Reply {}

  /** Not carried out; who asked is the only one that is told. */
  record Refused(Refusal refusal) implements Reply {
    /** As {@link #Refused(Refusal)}. */
    public Refused(Refusal.Code code, String text) {
      this(new Refusal(code, text));
    }
  }

  /**
   * Carried out, and ended by an error, which stands in the log already: that of a secondary
   * program, or one of our own.
   */
  record Failed(ScriptFailure failure) implements Reply {}

  /**
   * Not carried out, and perhaps later: too many other commands wait, or the controller did not
   * come to it in time.
   *
   * @param text which of these
   */
  record Busy(String text) implements Reply {}

  /** What interpreter mode is at. */
  record InterpreterState(InterpreterStatus status) implements Reply {}

  /** What interpreter mode says to a line. */
  record Interpreted(Interpreter.Response reply) implements Reply {}

  /**
   * What a device of the cell says.
   *
   * @param bytes one {@code char} a byte; empty for nothing
   */
  record Told(String bytes) implements Reply {}

  /** What a procedure of a device of the cell returns. */
  record Returned(Value value) implements Reply {}

  /** Carried out. */
  static Reply done() {
    return new Done();
  }

  /** Done, unless there is a reason against it. */
  static Reply unless(Optional<Refusal> refusal) {
    return refusal.isPresent() ? new Refused(refusal.get()) : done();
  }

  /** Why the command has not had its effect, in words; empty if it has. */
  default Optional<String> complaint() {
    return switch (this) {
      case Refused refused -> Optional.of(refused.refusal().text());
      case Failed failed -> Optional.of(failed.failure().message());
      case Busy busy -> Optional.of(busy.text());
      case Done _, InterpreterState _, Interpreted _, Told _, Returned _ -> Optional.empty();
    };
  }
}
