package org.pendant.protocols.natives;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NativeFolderTest {
  @TempDir Path home;

  @BeforeEach
  void onlyWhereFoldersHaveModes() {
    assumeTrue(Files.getFileAttributeView(home, PosixFileAttributeView.class) != null);
  }

  private static String mode(Path folder) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(folder));
  }

  private static void setMode(Path folder, String mode) throws IOException {
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString(mode));
  }

  private Path cache() {
    return home.resolve("cache");
  }

  private void assertRefused(String reason) throws IOException {
    IOException refused = assertThrows(IOException.class, () -> NativeFolder.in(cache()));
    assertTrue(refused.getMessage().contains(reason), refused.getMessage());
    Path other = NativeFolder.of(Optional.of(cache()));
    assertNotEquals(cache(), other.getParent());
    assertEquals("rwx------", mode(other));
  }

  @Test
  void itIsMadeForTheUserAlone() throws IOException {
    Path folder = NativeFolder.of(Optional.of(cache()));
    assertEquals(cache().toRealPath(), folder.getParent());
    assertEquals("rwx------", mode(folder));
    assertEquals(folder, NativeFolder.of(Optional.of(cache())), "and found again");
  }

  @Test
  void aLinkInItsPlaceIsRefused() throws IOException {
    Path elsewhere = Files.createDirectory(home.resolve("elsewhere"));
    setMode(elsewhere, "rwx------");
    Files.createDirectory(cache());
    Files.createSymbolicLink(cache().resolve("pendant-native"), elsewhere);
    assertRefused("is a link");
  }

  @Test
  void aFolderThatOthersCouldHaveFilledIsRefused() throws IOException {
    setMode(NativeFolder.in(cache()), "rwxrwxrwx");
    assertRefused("is open to others");
  }

  @Test
  void aFolderOfSomebodyElseIsRefused() throws IOException {
    Path folder = NativeFolder.in(cache());
    assumeTrue(givenAway(folder), "only the superuser can give a folder away");
    assertRefused("belongs to");
  }

  @Test
  void aFolderThatOthersCanExchangeIsRefused() throws IOException {
    NativeFolder.in(cache());
    setMode(cache(), "rwxrwxrwx");
    assertRefused("can be changed by others");
  }

  @Test
  void withoutACacheThereIsOneForTheProcess() throws IOException {
    Path first = NativeFolder.of(Optional.empty());
    assertEquals("rwx------", mode(first));
    assertNotEquals(first, NativeFolder.of(Optional.empty()), "its name cannot be foretold");
  }

  private static boolean givenAway(Path folder) {
    try {
      Files.setAttribute(folder, "unix:uid", 65_534);
      return true;
    } catch (IOException e) {
      return false;
    }
  }
}
