package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class FileSearchTest {
  @TempDir private Path folder;
  private final List<Place> found = new ArrayList<>();

  @BeforeEach
  void writeScripts() throws IOException {
    Files.createDirectories(folder.resolve("cell"));
    Files.writeString(folder.resolve("a.script"), "def a():\r\n  movej(home)\r\nend\r\n");
    Files.writeString(folder.resolve("cell/b.script"), "movel(p1)\nmovel(p2)\n");
    Files.writeString(folder.resolve("notes.txt"), "movej\n");
  }

  private FileSearch search(String words) {
    return new FileSearch(folder, new SearchQuery(words, false, false, false));
  }

  @Test
  void findsPlacesInScriptsOfAllFolders() throws IOException {
    FileSearch.Summary summary = search("move").run(found::add, (done, all) -> {}, () -> false);

    assertEquals(List.of("a.script", "cell/b.script", "cell/b.script"), names());
    assertEquals(2, found.getFirst().line());
    assertEquals(3, found.getFirst().column());
    assertEquals("  movej(home)", found.getFirst().text());
    assertEquals("3 places in 2 scripts", summary.sentence());
  }

  private List<String> names() {
    return found.stream().map(place -> place.name().replace('\\', '/')).toList();
  }

  @Test
  void readsLatin1WhereThereIsNoUtf8() throws IOException {
    Files.write(
        folder.resolve("old.script"), "# gr\u00fcn\n".getBytes(StandardCharsets.ISO_8859_1));
    search("gr\u00fcn").run(found::add, (done, all) -> {}, () -> false);

    assertEquals(List.of("old.script"), names());
  }

  @Test
  void endsWhenItIsCancelled() throws IOException {
    FileSearch.Summary summary =
        search("move").run(found::add, (done, all) -> {}, () -> !found.isEmpty());

    assertEquals(List.of("a.script"), names());
    assertEquals(false, summary.complete());
  }

  @Test
  void endsAtTheMostPlaces() throws IOException {
    Files.writeString(folder.resolve("long.script"), "x\n".repeat(FileSearch.MAX_PLACES + 1));
    FileSearch.Summary summary = search("x").run(found::add, (done, all) -> {}, () -> false);

    assertEquals(FileSearch.MAX_PLACES, found.size());
    assertEquals(FileSearch.MAX_PLACES, summary.places());
    assertEquals(false, summary.complete());
  }

  @Test
  void saysOneAsOneAndWhatWasNotRead() {
    assertEquals("1 place in 1 script", new FileSearch.Summary(1, 1, 0, true).sentence());
    assertEquals(
        "0 places in 2 scripts; 1 not read: larger than 4 MiB, or not allowed",
        new FileSearch.Summary(2, 0, 1, true).sentence());
  }
}
