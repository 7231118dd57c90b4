package org.pendant.controller.device.gripper;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.pendant.controller.external.DeviceTalk;

/**
 * Gripper lines: what an adaptive gripper is told by lines of text, as the driver on the controller
 * of a real robot takes them at port {@value #PORT}: {@code SET POS 255 SPE 255} is answered by
 * {@code ack} without a newline, {@code GET POS} by {@code POS 3}, one that ends without a newline
 * by the number alone, anything else by {@code ?}.
 */
public final class GripperLines implements DeviceTalk {
  /** The port of the driver on a robot's controller. */
  public static final int PORT = 63352;

  private static final int MAX_LINE = 1024;
  private static final String NO = "?";

  private final AdaptiveGripper gripper;
  private final Station station;
  private final Consumer<String> complain;
  private final StringBuilder line = new StringBuilder();

  /** The number of the gripper on its line, which all connections share. */
  public static final class Station {
    private int number = 9;

    /** Of a gripper as it is delivered. */
    public Station() {}
  }

  /**
   * A connection that was just opened.
   *
   * @param complain is told what is no command
   */
  public GripperLines(AdaptiveGripper gripper, Station station, Consumer<String> complain) {
    this.gripper = gripper;
    this.station = station;
    this.complain = complain;
  }

  @Override
  public String hear(String bytes) {
    if (bytes.isEmpty() && line.isEmpty()) {
      return "";
    }
    StringBuilder answers = new StringBuilder();
    line.append(bytes);
    for (int end = line.indexOf("\n"); end >= 0; end = line.indexOf("\n")) {
      String text = line.substring(0, end).strip();
      line.delete(0, end + 1);
      if (!text.isEmpty()) {
        answers.append(answer(text, true));
      }
    }
    // a command without its newline has ended when nothing has followed it for a frame
    if (bytes.isEmpty() || line.length() > MAX_LINE) {
      String text = line.toString().strip();
      line.setLength(0);
      if (!text.isEmpty()) {
        answers.append(answer(text, false));
      }
    }
    return answers.toString();
  }

  private String answer(String text, boolean named) {
    String[] words = text.split(" +", -1);
    if (words[0].equals("GET") && words.length == 2) {
      Optional<String> value = value(words[1]);
      if (value.isPresent()) {
        return named ? words[1] + " " + value.get() + "\n" : value.get();
      }
      return no("noVariable", gripper.name(), text, words[1]);
    }
    if (words[0].equals("SET") && words.length >= 3 && words.length % 2 == 1) {
      for (int i = 1; i < words.length; i += 2) {
        Optional<String> wrong = refusal(text, words[i], words[i + 1]);
        if (wrong.isPresent()) {
          complain.accept(wrong.get());
          return NO;
        }
      }
      set(words);
      return "ack";
    }
    return no("badRequest", gripper.name(), text);
  }

  private String no(String key, Object... values) {
    complain.accept(GripperTexts.text(key, values));
    return NO;
  }

  private Optional<String> refusal(String line, String name, String text) {
    int most =
        switch (name) {
          case "ACT", "GTO", "ATR", "ARD", "ADR" -> 1;
          case "POS", "SPE", "FOR", "SID" -> AdaptiveGripper.MAX;
          default -> -1;
        };
    if (most < 0) {
      return Optional.of(GripperTexts.text("cannotBeSet", gripper.name(), line, name));
    }
    OptionalInt number = number(text);
    return number.isPresent() && number.getAsInt() >= 0 && number.getAsInt() <= most
        ? Optional.empty()
        : Optional.of(GripperTexts.text("numberRange", gripper.name(), line, name, text, most));
  }

  private static OptionalInt number(String text) {
    try {
      return OptionalInt.of(Integer.parseInt(text));
    } catch (NumberFormatException _) {
      return OptionalInt.empty();
    }
  }

  /** Speed and force first: the same line may tell it to go. */
  private void set(String... words) {
    for (int i = 1; i < words.length; i += 2) {
      int number = Integer.parseInt(words[i + 1]);
      switch (words[i]) {
        case "SPE" -> gripper.setSpeed(number);
        case "FOR" -> gripper.setForce(number);
        case "ARD", "ADR" -> gripper.setReleaseOpens(number == 1);
        case "SID" -> station.number = number;
        default -> {}
      }
    }
    for (int i = 1; i < words.length; i += 2) {
      int number = Integer.parseInt(words[i + 1]);
      switch (words[i]) {
        case "ACT" -> gripper.activate(number == 1);
        case "POS" -> gripper.request(number);
        case "GTO" -> gripper.go(number == 1);
        case "ATR" -> {
          if (number == 1) {
            gripper.release();
          }
        }
        default -> {}
      }
    }
  }

  private Optional<String> value(String name) {
    return Optional.ofNullable(
        switch (name) {
          case "ACT" -> bit(gripper.active());
          case "GTO" -> bit(gripper.goes());
          case "ATR" -> bit(gripper.released());
          case "ARD", "ADR" -> bit(gripper.releaseOpens());
          case "FOR" -> Integer.toString(gripper.force());
          case "SPE" -> Integer.toString(gripper.speed());
          case "POS" -> Integer.toString(gripper.position());
          // scripts take three digits of this one, and two of the fault
          case "PRE" -> String.format(Locale.ROOT, "%03d", gripper.requested());
          case "FLT" -> String.format(Locale.ROOT, "%02d", gripper.fault().number());
          case "STA" -> Integer.toString(gripper.status());
          case "OBJ" -> Integer.toString(gripper.contact().ordinal());
          case "SID" -> Integer.toString(station.number);
          case "PCO" -> "0";
          case "COU" -> gripper.fingers().pressing() ? "30" : "0";
          case "VER", "FWV" -> "Pendant";
          default -> null;
        });
  }

  private static String bit(boolean on) {
    return on ? "1" : "0";
  }
}
