package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What others leave among the temporary files is neither loaded nor followed. */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
final class NativeCodeTest {
  @TempDir Path folder;

  @Test
  void theSerialLibraryKeepsToAFolderOfTheUser() throws IOException {
    Path precious =
        Files.writeString(Files.createDirectory(folder.resolve("home")).resolve("file"), "kept");
    Path planted = Files.createDirectories(folder.resolve("tmp/jSerialComm/2.11.4"));
    Files.writeString(planted.resolve("libjSerialComm.so"), "code of another user");
    Files.createSymbolicLink(folder.resolve("tmp/jSerialComm/old"), precious.getParent());
    Launcher.script(
        folder,
        "t.script",
        "def t():\n  set_tool_communication(True, 115200, 0, 1, 1.5, 3.5)\n  sync()\nend\n");

    Launcher.Result result =
        Launcher.shell(
            folder,
            "PENDANT_JAVA_OPTIONS=-Djava.io.tmpdir=$PWD/tmp XDG_CACHE_HOME=$PWD/cache"
                + " \"$PENDANT\" run --tool-serial /dev/null t.script");

    assertEquals(0, result.exitCode(), result.errors());
    assertEquals("kept", Files.readString(precious));
    assertEquals("code of another user", Files.readString(planted.resolve("libjSerialComm.so")));
    assertTrue(
        files(folder.resolve("cache/pendant-native")).contains("libjSerialComm.so"),
        "it has been unpacked where only the user can write");
  }

  private static List<String> files(Path below) throws IOException {
    try (Stream<Path> all = Files.walk(below)) {
      return all.map(each -> each.getFileName().toString()).toList();
    }
  }
}
