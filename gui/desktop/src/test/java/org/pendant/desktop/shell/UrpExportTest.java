package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

final class UrpExportTest {
  @Test
  void everyNoteHasALineOfItsOwn() {
    assertEquals("\u2022 one\n\u2022 two", UrpExport.listed(List.of("one", "two")));
  }

  @Test
  void longListsSayWhereTheRestIs() {
    List<String> notes = IntStream.rangeClosed(1, 12).mapToObj(i -> "note " + i).toList();
    String listed = UrpExport.listed(notes);
    assertTrue(listed.endsWith("and 4 more notes; pendant convert lists all of them"), listed);
    assertEquals(9, listed.lines().count());
  }
}
