package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class OpenFilesTest {
  private static final Owner FIRST = new Owner(7, 1_000);
  private static final Owner SECOND = new Owner(8, 2_000);

  @TempDir Path folder;

  private final List<Owner> alive = new ArrayList<>(List.of(FIRST, SECOND));
  private Path shared;
  private Path program;

  @BeforeEach
  void makeFiles() throws IOException {
    shared = folder.resolve("state");
    program = Files.writeString(folder.resolve("a.script"), "x = 1\n");
  }

  private OpenFiles window(Owner owner) {
    return new OpenFiles(shared, owner, alive::contains);
  }

  @Test
  void bothWindowsSeeAFileThatBothHaveOpen() throws IOException {
    OpenFiles first = window(FIRST);
    OpenFiles second = window(SECOND);
    assertEquals(List.of(), first.share(List.of(program)));
    assertEquals(List.of(program), second.share(List.of(program, folder.resolve("b.script"))));
    assertEquals(List.of(program), first.share(List.of(program)));
  }

  @Test
  void twoWindowsOfOneProcessSeeEachOther() throws IOException {
    OpenFiles first = window(FIRST);
    OpenFiles second = window(FIRST);
    first.share(List.of(program));
    assertEquals(List.of(program), second.share(List.of(program)));
  }

  @Test
  void aFileThatIsClosedOrWhoseWindowIsClosedIsOpenElsewhereNoMore() throws IOException {
    OpenFiles first = window(FIRST);
    OpenFiles second = window(SECOND);
    first.share(List.of(program));
    first.share(List.of());
    assertEquals(List.of(), second.share(List.of(program)));
    first.share(List.of(program));
    first.close();
    assertEquals(List.of(), second.share(List.of(program)));
    assertEquals(List.of(), first.share(List.of(program)), "a window that is closed tells nothing");
    assertEquals(1, left());
  }

  @Test
  void whatAKilledWindowHasLeftIsTakenAway() throws IOException {
    window(FIRST).share(List.of(program));
    alive.remove(FIRST);
    // Another process has got its number.
    alive.add(new Owner(FIRST.process(), 3_000));
    assertEquals(List.of(), window(SECOND).share(List.of(program)));
    assertEquals(1, left());
  }

  @Test
  void aLinkAndOtherWaysToTheSameFileAreThatFile() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("link.script"), program);
    window(FIRST).share(List.of(link));
    Path around = folder.resolve("state/../a.script");
    assertEquals(List.of(around), window(SECOND).share(List.of(around)));
  }

  @Test
  void filesOfOddNamesAreKnownToo() throws IOException {
    Path odd = Files.writeString(folder.resolve("a b%20\u00e9\nc.script"), "");
    window(FIRST).share(List.of(odd));
    assertEquals(List.of(odd), window(SECOND).share(List.of(odd)));
  }

  @Test
  void whatIsNoneOfOursIsLeftAlone() throws IOException {
    Files.createDirectories(shared);
    Path strange = Files.write(shared.resolve("x.open"), new byte[] {1, 2, (byte) 0xff});
    Path broken = Files.writeString(shared.resolve("y.open"), "pendant open files 1\n7 1000\n a b");
    assertEquals(List.of(), window(SECOND).share(List.of(program)));
    assertTrue(Files.exists(strange));
    assertTrue(Files.exists(broken));
  }

  @Test
  void nothingIsWrittenWhileNothingIsOpen() throws IOException {
    window(FIRST).share(List.of());
    assertFalse(Files.exists(shared));
  }

  private long left() throws IOException {
    try (Stream<Path> files = Files.list(shared)) {
      return files.count();
    }
  }
}
