package org.pendant.protocols.script;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Raw command: a line that the box carries out itself: it is no script. */
sealed interface RawCommand {

  /** {@code power on}: the arm gets power and rests on its brakes. */
  record PowerOn() implements RawCommand {}

  /** {@code power off}. */
  record PowerOff() implements RawCommand {}

  /** {@code set robotmode run}: power and no brakes; also ends {@link Freedrive}. */
  record Run() implements RawCommand {}

  /** {@code set robotmode freedrive}: the arm may be guided by hand. */
  record Freedrive() implements RawCommand {}

  /** {@code set unlock protective stop}. */
  record UnlockProtectiveStop() implements RawCommand {}

  /** {@code stop program}. */
  record StopProgram() implements RawCommand {}

  /**
   * {@code set speed 0.5}: moves the speed slider.
   *
   * @param fraction as the client wrote it, not checked
   */
  record SetSpeed(double fraction) implements RawCommand {}

  /**
   * {@code set real} and {@code set sim}: which arm is meant.
   *
   * @param real false for a simulated one
   */
  record ChooseArm(boolean real) implements RawCommand {}

  /**
   * {@code request_value 3 12.5}: answers a question of a program or closes a popup. The form is
   * ours.
   *
   * @param number of the question or popup
   * @param value the answer, bytes, one {@code char} a byte; may be empty
   */
  record AnswerRequest(long number, String value) implements RawCommand {}

  /** Reads {@code line}; empty if it must be script. Words are in small letters. */
  static Optional<RawCommand> read(String line) {
    return switch (line.strip().replaceAll("\\s+", " ")) {
      case "power on" -> Optional.of(new PowerOn());
      case "power off" -> Optional.of(new PowerOff());
      case "set robotmode run" -> Optional.of(new Run());
      case "set robotmode freedrive" -> Optional.of(new Freedrive());
      case "set unlock protective stop" -> Optional.of(new UnlockProtectiveStop());
      case "stop program" -> Optional.of(new StopProgram());
      case "set real" -> Optional.of(new ChooseArm(true));
      case "set sim" -> Optional.of(new ChooseArm(false));
      default -> Patterns.withValue(line);
    };
  }

  /** The commands that carry a value. */
  final class Patterns {
    private static final Pattern SPEED =
        Pattern.compile("\\s*set\\s+speed\\s+(\\d{0,9}\\.?\\d{0,18})\\s*");
    private static final Pattern ANSWER =
        Pattern.compile("\\s*request_value\\s+(\\d{1,18})(?:\\s(.*))?", Pattern.DOTALL);
    private static final Pattern DIGIT = Pattern.compile(".*\\d.*");

    private Patterns() {}

    private static Optional<RawCommand> withValue(String line) {
      Matcher speed = SPEED.matcher(line);
      if (speed.matches() && DIGIT.matcher(speed.group(1)).matches()) {
        return Optional.of(new SetSpeed(Double.parseDouble(speed.group(1))));
      }
      Matcher answer = ANSWER.matcher(line);
      if (answer.matches()) {
        String value = answer.group(2);
        return Optional.of(
            new AnswerRequest(Long.parseLong(answer.group(1)), value == null ? "" : value));
      }
      return Optional.empty();
    }
  }
}
