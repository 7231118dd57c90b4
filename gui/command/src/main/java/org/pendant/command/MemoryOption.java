package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.ControllerOptions;

/** Option {@code --memory}: what the values of a program may take. */
final class MemoryOption {
  static final Option OPTION =
      Option.text("--memory", "SIZE")
          .documented(
              "256MB",
              "what the values of a program may take together, in kB, MB or GB: 256 MB (default),"
                  + " or a third of Java's memory where that is less; at most that third. A program"
                  + " that needs more fails");

  private static final Pattern SIZE =
      Pattern.compile("(\\d{1,12}(?:\\.\\d{1,6})?)\\s?(kb|mb|gb)", Pattern.CASE_INSENSITIVE);
  private static final Map<String, Integer> POWERS_OF_TEN = Map.of("kb", 3, "mb", 6, "gb", 9);
  private static final long MIN_BYTES = 100_000;

  private MemoryOption() {}

  /** The size that the command line asks for, or the standard one, bytes. */
  static long of(Arguments arguments) throws UsageException {
    Optional<String> text = arguments.value(OPTION);
    return text.isPresent()
        ? bytes(text.get(), ControllerOptions.mostMemoryBytes())
        : ControllerOptions.standardMemoryBytes();
  }

  /**
   * Reads a size.
   *
   * @param most what this process has room for, bytes
   */
  static long bytes(String text, long most) throws UsageException {
    Matcher size = SIZE.matcher(text.strip());
    if (!size.matches()) {
      throw new UsageException(text("memoryMustBe", OPTION.name(), text));
    }
    int power = POWERS_OF_TEN.get(size.group(2).toLowerCase(Locale.ROOT));
    long bytes = new BigDecimal(size.group(1)).scaleByPowerOfTen(power).longValue();
    if (bytes < MIN_BYTES) {
      throw new UsageException(text("memoryAtLeast", OPTION.name(), text));
    }
    if (bytes > most) {
      throw new UsageException(
          text(
              "memoryAtMost",
              OPTION.name(),
              text,
              most / 1_000_000,
              Math.ceilDiv(ControllerOptions.SHARE_OF_HEAP * bytes, 1 << 20)));
    }
    return bytes;
  }
}
