package org.pendant.kit.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class FileSettingsTest {
  @TempDir Path folder;

  private Path file() {
    return folder.resolve("sub").resolve("settings.txt");
  }

  @Test
  void whatWasPutIsThereAtTheNextStart() {
    try (FileSettings settings = FileSettings.open(file())) {
      settings.put("a.text", " two\nlines \\ and = \u00e9 ");
      settings.put("a.empty", "");
    }
    try (FileSettings settings = FileSettings.open(file())) {
      assertEquals(Optional.of(" two\nlines \\ and = \u00e9 "), settings.get("a.text"));
      assertEquals(Optional.of(""), settings.get("a.empty"));
      assertEquals(Optional.empty(), settings.get("a.none"));
      assertEquals(Optional.empty(), settings.notice());
    }
  }

  @Test
  void linesThatAreNoSettingsAreIgnoredWithANoticeAndACopy() throws IOException {
    Path file = folder.resolve("settings.txt");
    Files.writeString(file, "# mine\nlook.theme = dark\nnonsense\n= 3\n");
    try (FileSettings settings = FileSettings.open(file)) {
      assertEquals(Optional.of("dark"), settings.get("look.theme"));
      assertEquals(
          "Settings "
              + file
              + " has lines that are no settings: 3, 4; they are ignored, a copy is "
              + file
              + ".bad",
          settings.notice().orElseThrow());
    }
    assertTrue(Files.exists(folder.resolve("settings.txt.bad")));
  }

  @Test
  void aFileThatIsNoTextIsIgnored() throws IOException {
    Path file = folder.resolve("settings.txt");
    Files.write(file, new byte[] {(byte) 0xFF, (byte) 0xFE, 0, 1});
    try (FileSettings settings = FileSettings.open(file)) {
      assertTrue(settings.notice().orElseThrow().contains("is no text"));
      settings.put("a", "b");
    }
    assertTrue(Files.readString(file).contains("a = b"));
  }

  @Test
  void aFileThatCannotBeReadIsNotWrittenOver() throws IOException {
    Path file = folder.resolve("settings.txt");
    Files.write(file, new byte[2 << 20]);
    try (FileSettings settings = FileSettings.open(file)) {
      assertEquals(
          "Settings "
              + file
              + " are too large to be settings; what is changed is forgotten at the end",
          settings.notice().orElseThrow());
      settings.put("a", "b");
    }
    assertEquals(2 << 20, Files.size(file));
  }

  @Test
  void troubleInWritingIsToldOnce() throws IOException {
    Path inTheWay = folder.resolve("sub");
    Files.writeString(inTheWay, "no folder");
    List<String> told = new CopyOnWriteArrayList<>();
    try (FileSettings settings = FileSettings.open(file())) {
      settings.onTrouble(told::add);
      settings.put("a", "b");
    }
    assertEquals(
        List.of(
            "Settings cannot be written: "
                + file()
                + ": "
                + inTheWay
                + " is not a folder; what is changed is forgotten at the end"),
        told);
  }

  @Test
  void theFolderIsTheOneThatWasNamedLast() {
    Map<String, String> xdg = Map.of("XDG_CONFIG_HOME", "/xdg");
    Map<String, String> home = Map.of("user.home", "/home/me");
    assertEquals(Path.of("/xdg/pendant"), ConfigurationFolder.of(home, xdg));
    assertEquals(Path.of("/home/me/.config/pendant"), ConfigurationFolder.of(home, Map.of()));
    assertEquals(Path.of("/mine"), ConfigurationFolder.of(Map.of("pendant.config", "/mine"), xdg));
  }
}
