package org.pendant.recording;

import java.util.List;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramEvent;

/** Frame delta: what is new in one frame, as in {@link ControllerState}. */
record FrameDelta(
    List<LogEntry> entries,
    List<Popup> popups,
    List<Question> questions,
    List<ProgramEvent> events,
    long newestEntry) {
  /** The longest text of a log line that is recorded, bytes. */
  private static final int MAX_TEXT = 1 << 16;

  static final FrameDelta NONE = new FrameDelta(List.of(), List.of(), List.of(), List.of(), 0);

  FrameDelta {
    entries = List.copyOf(entries);
    popups = List.copyOf(popups);
    questions = List.copyOf(questions);
    events = List.copyOf(events);
  }

  static boolean in(ControllerState state) {
    return !state.newLines().equals(LogLines.NONE)
        || !state.newPopups().isEmpty()
        || !state.newQuestions().isEmpty()
        || !state.newProgramEvents().isEmpty();
  }

  static FrameDelta of(ControllerState state) {
    return new FrameDelta(
        state.newEntries().stream().map(each -> each.shortened(MAX_TEXT)).toList(),
        state.newPopups(),
        state.newQuestions(),
        state.newProgramEvents(),
        state.newestEntry());
  }

  /** In a frame that brings none: only the number of the newest log line stays. */
  FrameDelta old() {
    return newestEntry == 0
        ? NONE
        : new FrameDelta(List.of(), List.of(), List.of(), List.of(), newestEntry);
  }
}
