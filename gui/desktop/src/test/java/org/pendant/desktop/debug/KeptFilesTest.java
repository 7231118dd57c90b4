package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.editor.TextPlace;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;
import org.pendant.script.debug.Breakpoint;

final class KeptFilesTest {
  private static final Path PICK = Path.of("/programs/pick it.script");
  private static final KeptFile KEPT =
      new KeptFile(
          new TextPlace(12, 3, List.of(4, 9)),
          List.of(
              Breakpoint.at(4).when("count == 3").fromHit(2),
              Breakpoint.at(9).disabled().logging("turn {i}")));

  private final Map<String, String> values = new HashMap<>();
  private final Settings settings = new MemorySettings(values);

  private KeptFiles again() {
    return new KeptFiles(settings);
  }

  @Test
  void whatIsKeptOfAFileIsThereAtTheNextStart() {
    KeptFiles files = again();
    files.put(PICK, KEPT);
    files.write();
    assertEquals(Optional.of(KEPT), again().of(PICK));
    assertEquals(Optional.empty(), again().notice());
  }

  @Test
  void aFileAtItsStartTakesNoRoom() {
    KeptFiles files = again();
    files.put(PICK, KEPT);
    files.put(PICK, new KeptFile(TextPlace.START, List.of()));
    files.write();
    assertEquals("", values.getOrDefault(KeptFiles.SETTING, ""));
  }

  @Test
  void theFilesThatWereUsedLastAreKept() {
    KeptFiles files = again();
    for (int i = 0; i < 300; i++) {
      files.put(Path.of("/programs/" + i + ".script"), KEPT);
    }
    files.put(Path.of("/programs/150.script"), new KeptFile(KEPT.place(), List.of()));
    files.write();
    assertTrue(again().of(Path.of("/programs/299.script")).isPresent());
    assertTrue(again().of(Path.of("/programs/150.script")).isPresent());
    assertEquals(Optional.empty(), again().of(Path.of("/programs/7.script")));
  }

  @Test
  void aDamagedPartIsToldAndTheOthersStay() {
    KeptFiles files = again();
    files.put(Path.of("/programs/a.script"), KEPT);
    files.put(PICK, KEPT);
    files.write();
    values.computeIfPresent(
        KeptFiles.SETTING, (name, text) -> text.replaceFirst("caret\t12", "caret\ttwelve"));
    assertEquals(Optional.empty(), again().of(Path.of("/programs/a.script")));
    assertEquals(Optional.of(KEPT), again().of(PICK));
    assertEquals(
        Optional.of(
            "Breakpoints, caret and folds are lost, as the settings are damaged there:"
                + " /programs/a.script"),
        again().notice());
  }

  @Test
  void anythingElseInItsPlaceIsToldToo() {
    values.put(KeptFiles.SETTING, "breakpoint\t0\ton\t1\t\nx");
    assertTrue(again().notice().isPresent());
  }
}
