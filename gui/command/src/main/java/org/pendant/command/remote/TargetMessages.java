package org.pendant.command.remote;

import java.util.Optional;
import org.pendant.protocols.primary.RobotMessage;
import org.pendant.testing.remote.TargetEvent;

/** Target messages: what the messages of a primary port are for tests. */
final class TargetMessages {
  /** The title of the message about a program that starts. */
  static final String STARTED = "PROGRAM_XXX_STARTED";

  /** The title of the message about a program that has ended. */
  static final String STOPPED = "PROGRAM_XXX_STOPPED";

  private TargetMessages() {}

  /** What has happened; empty where that is nothing to a test. */
  static Optional<TargetEvent> event(RobotMessage message) {
    return switch (message) {
      case RobotMessage.Text text -> Optional.of(new TargetEvent.Said(text.text()));
      case RobotMessage.ErrorCode error -> Optional.of(new TargetEvent.Noted(told(error)));
      case RobotMessage.Key key when key.title().equals(STARTED) ->
          Optional.of(new TargetEvent.Started());
      case RobotMessage.Key key when key.title().equals(STOPPED) ->
          Optional.of(new TargetEvent.Ended());
      case RobotMessage.Key key ->
          Optional.of(new TargetEvent.Noted(key.title() + ": " + key.text()));
      case RobotMessage.Request request ->
          Optional.of(
              request.wanted() == RobotMessage.Wanted.NOTHING
                  ? new TargetEvent.PopupOpened(request.id(), request.text())
                  : new TargetEvent.Asked(request.text()));
      case RobotMessage.RuntimeFault fault ->
          Optional.of(new TargetEvent.Failed(fault.line(), fault.column(), fault.text()));
      case RobotMessage.Version _,
          RobotMessage.Second _,
          RobotMessage.Safety _,
          RobotMessage.Labels _ ->
          Optional.empty();
    };
  }

  private static String told(RobotMessage.ErrorCode error) {
    String code = "C" + error.code() + "A" + error.argument();
    if (error.text().startsWith(code)) {
      return error.text();
    }
    return error.text().isEmpty() ? code : code + ": " + error.text();
  }
}
