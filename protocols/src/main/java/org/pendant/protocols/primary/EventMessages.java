package org.pendant.protocols.primary;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;
import org.pendant.language.source.ByteText;
import org.pendant.protocols.script.ScriptTrouble;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ScriptFailure;

/** Event messages: which messages tell what has happened. */
final class EventMessages {
  static final String STARTED = "PROGRAM_XXX_STARTED";
  static final String STOPPED = "PROGRAM_XXX_STOPPED";
  static final String SECONDARY_FAILED = "SECONDARY_PROGRAM_EXCEPTION_XXX";

  /** Says that a client may only read. */
  static final int READ_ONLY = 210;

  /** The longest text of a message, bytes. */
  static final int MAX_TEXT = 1 << 16;

  private static final Pattern CODE = Pattern.compile("C(\\d{1,9})A(\\d{1,9})");
  private static final double US_PER_S = 1e6;

  private EventMessages() {}

  /** Controller time as messages carry it, µs. */
  static long timeUs(ControllerState state) {
    return Math.round(state.timeS() * US_PER_S);
  }

  /**
   * What happened in a frame. The order within a frame is not known; a program has started before
   * it writes and ends after.
   *
   * @param entries log lines of the frame
   * @param before the safety mode in the frame before
   */
  static List<RobotMessage> of(ControllerState state, List<LogEntry> entries, SafetyMode before) {
    long timeUs = timeUs(state);
    List<ProgramEvent> events = state.newProgramEvents();
    if (events.isEmpty()
        && entries.isEmpty()
        && state.newPopups().isEmpty()
        && state.newQuestions().isEmpty()
        && before == state.safety().safetyMode()) {
      return List.of();
    }
    List<RobotMessage> messages = new ArrayList<>();
    boolean endsLast = !events.isEmpty() && events.getLast() instanceof ProgramEvent.Ended;
    for (ProgramEvent event : endsLast ? events.subList(0, events.size() - 1) : events) {
      add(messages, timeUs, event);
    }
    for (LogEntry entry : entries) {
      of(timeUs, entry).ifPresent(messages::add);
    }
    for (Popup popup : state.newPopups()) {
      messages.add(
          new RobotMessage.Request(
              timeUs, popup.number(), RobotMessage.Wanted.NOTHING, popup.text()));
    }
    for (Question question : state.newQuestions()) {
      messages.add(
          new RobotMessage.Request(
              timeUs, question.number(), wanted(question.kind()), question.text()));
    }
    if (before != state.safety().safetyMode()) {
      messages.add(
          new RobotMessage.Safety(timeUs, RobotBits.coarse(state.safety().safetyMode()).code()));
    }
    if (endsLast) {
      add(messages, timeUs, events.getLast());
    }
    return messages;
  }

  private static void add(List<RobotMessage> messages, long timeUs, ProgramEvent event) {
    switch (event) {
      case ProgramEvent.Started started ->
          messages.add(new RobotMessage.Key(timeUs, STARTED, started.name()));
      case ProgramEvent.Ended ended -> {
        if (ended.ending() instanceof Ending.Failed failed) {
          ScriptFailure why = failed.failure();
          messages.add(
              new RobotMessage.RuntimeFault(
                  timeUs, why.line(), why.column(), ByteText.asBytes(why.message())));
        }
        messages.add(new RobotMessage.Key(timeUs, STOPPED, ended.name()));
      }
      case ProgramEvent.SecondaryFailed failed ->
          messages.add(
              new RobotMessage.Key(
                  timeUs, SECONDARY_FAILED, ByteText.asBytes(failed.failure().message())));
    }
  }

  private static Optional<RobotMessage> of(long timeUs, LogEntry entry) {
    if (entry.origin() == LogEntry.Origin.SCRIPT) {
      return Optional.of(new RobotMessage.Text(timeUs, LogEntry.shortened(entry.text(), MAX_TEXT)));
    }
    Matcher code = CODE.matcher(entry.code());
    return code.matches()
        ? Optional.of(
            new RobotMessage.ErrorCode(
                timeUs,
                Integer.parseInt(code.group(1)),
                Integer.parseInt(code.group(2)),
                level(entry.level()),
                ByteText.asBytes(entry.text())))
        : Optional.empty();
  }

  private static RobotMessage.Level level(LogEntry.Level level) {
    return switch (level) {
      case INFO -> RobotMessage.Level.INFO;
      case WARNING -> RobotMessage.Level.WARNING;
      case ERROR -> RobotMessage.Level.VIOLATION;
    };
  }

  private static RobotMessage.Wanted wanted(Question.Kind kind) {
    return switch (kind) {
      case BOOLEAN -> RobotMessage.Wanted.BOOLEAN;
      case INTEGER -> RobotMessage.Wanted.INTEGER;
      case FLOAT -> RobotMessage.Wanted.FLOAT;
      case STRING -> RobotMessage.Wanted.STRING;
    };
  }

  /** What clients are told about something that did not run. */
  static RobotMessage of(long timeUs, ScriptTrouble trouble) {
    return switch (trouble) {
      case ScriptTrouble.NotCompiled wrong ->
          new RobotMessage.RuntimeFault(
              RobotMessage.BEFORE, wrong.line(), wrong.column(), wrong.text());
      case ScriptTrouble.NotStarted refused ->
          new RobotMessage.RuntimeFault(RobotMessage.BEFORE, 1, 1, refused.why());
      case ScriptTrouble.ReadOnly readOnly ->
          new RobotMessage.ErrorCode(
              timeUs,
              READ_ONLY,
              0,
              RobotMessage.Level.WARNING,
              "the connection is read-only: it was made in local control");
    };
  }
}
