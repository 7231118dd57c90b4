package org.pendant.controller.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.script.value.ScriptError;

class ProgramsFolderTest {
  private static final byte[] CONTENT = {'G', '0'};

  @TempDir private Path disk;
  private ProgramsFolder folder;

  @BeforeEach
  void fill() throws IOException {
    Path root = Files.createDirectories(disk.resolve("own"));
    Files.createDirectories(root.resolve("sub.nc"));
    Files.createDirectories(root.resolve("deep"));
    Files.write(root.resolve("a.nc"), CONTENT);
    Files.write(root.resolve("deep/b.NC"), CONTENT);
    Files.write(root.resolve("secret.txt"), CONTENT);
    Files.write(disk.resolve("outside.nc"), CONTENT);
    folder = ProgramsFolder.at(root);
  }

  private byte[] read(String name) throws ScriptError {
    String bytes = new String(name.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
    return folder.find(bytes, ".nc", 10).read();
  }

  private void refuses(String name, String reason) {
    ScriptError error = assertThrows(ScriptError.class, () -> read(name));
    assertEquals("file-refused", error.code());
    assertEquals("\"" + name + "\" " + reason, error.getMessage());
  }

  @Test
  void filesBelowItAreRead() throws ScriptError, IOException {
    assertArrayEquals(CONTENT, read("a.nc"));
    assertArrayEquals(CONTENT, read("deep/b.NC"));
    assertArrayEquals(CONTENT, read("/programs/deep/b.NC"));
    Files.write(disk.resolve("own/träger.nc"), CONTENT);
    assertArrayEquals(CONTENT, read("träger.nc"));
  }

  @Test
  void whatIsElsewhereIsRefused() {
    String elsewhere =
        "is not in the programs folder, must be a name in it or begin with /programs/";
    refuses(disk.resolve("outside.nc").toString(), elsewhere);
    refuses("/etc/x.nc", elsewhere);
    refuses("C:x.nc", elsewhere);
    refuses("..\\outside.nc", elsewhere);
    refuses("../outside.nc", "leads out of the programs folder");
    refuses("deep/../../outside.nc", "leads out of the programs folder");
    refuses("/programs/../outside.nc", "leads out of the programs folder");
    refuses("/programs//etc/x.nc", elsewhere);
  }

  @Test
  void linksOutOfItAreRefusedAndLinksWithinAreNot() throws ScriptError, IOException {
    Path root = disk.resolve("own");
    Files.createSymbolicLink(root.resolve("out.nc"), disk.resolve("outside.nc"));
    Files.createSymbolicLink(root.resolve("up"), disk);
    Files.createSymbolicLink(root.resolve("in.nc"), root.resolve("a.nc"));
    refuses("out.nc", "is a link that leads out of the programs folder");
    refuses("up/outside.nc", "is a link that leads out of the programs folder");
    assertArrayEquals(CONTENT, read("in.nc"));
  }

  @Test
  void whatIsNoSuchFileIsRefused() throws IOException {
    refuses("none.nc", "is not there: no such file in the programs folder");
    ScriptError inFile = assertThrows(ScriptError.class, () -> read("a.nc/b.nc"));
    assertTrue(inFile.getMessage().startsWith("\"a.nc/b.nc\" cannot be read"));
    refuses("sub.nc", "is not a file");
    refuses("secret.txt", "must be the name of a .nc file");
    refuses("", "must be the name of a .nc file");
    refuses("a\0.nc", "is not a file name");
    Files.write(disk.resolve("own/big.nc"), new byte[11]);
    refuses("big.nc", "is too large, must have at most 10 bytes");
  }

  @Test
  void aFileThatGrowsMeanwhileIsRefused() throws ScriptError, IOException {
    ProgramsFolder.Found found = folder.find("a.nc", ".nc", 10);
    Files.write(disk.resolve("own/a.nc"), new byte[11]);
    ScriptError error = assertThrows(ScriptError.class, found::read);
    assertTrue(error.getMessage().contains("is too large"), error.getMessage());
  }

  @Test
  void aTextWithoutAFileHasNone() throws IOException {
    folder = ProgramsFolder.of("no such program.script");
    refuses("a.nc", "cannot be read: the program is not in a folder");
    folder = ProgramsFolder.of(disk.resolve("own/secret.txt").toString());
    assertEquals(ProgramsFolder.at(disk.resolve("own")), folder);
  }
}
