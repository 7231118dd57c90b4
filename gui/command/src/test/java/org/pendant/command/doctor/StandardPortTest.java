package org.pendant.command.doctor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

final class StandardPortTest {
  private static final Path PAGE = Path.of("../../docs/protocols/README.md");

  /** Opened by an option, or by a device of a cell. */
  private static final SortedSet<Integer> ON_REQUEST = new TreeSet<>(List.of(54_321, 63_352));

  @Test
  void theyAreThoseOfTheDocumentation() throws IOException {
    SortedSet<Integer> documented =
        Files.readAllLines(PAGE).stream()
            .filter(line -> line.startsWith("| ") && Character.isDigit(line.charAt(2)))
            .map(line -> line.split("\\|")[1])
            .flatMap(cell -> Pattern.compile("\\d+").matcher(cell).results())
            .map(number -> Integer.valueOf(number.group()))
            .filter(number -> !ON_REQUEST.contains(number))
            .collect(Collectors.toCollection(TreeSet::new));

    SortedSet<Integer> looked =
        StandardPort.ALL.stream()
            .map(StandardPort::number)
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(documented, looked);
  }
}
