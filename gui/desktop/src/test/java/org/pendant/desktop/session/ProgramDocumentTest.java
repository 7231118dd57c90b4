package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class ProgramDocumentTest {
  @TempDir Path folder;

  @Test
  void itIsModifiedUntilTheTextIsTheOldOneAgain() {
    ProgramDocument document = ProgramDocument.untitled("a.script", "one");
    document.replace(0, 3, "two");
    assertTrue(document.modified());
    document.setText("one");
    assertFalse(document.modified());
  }

  @Test
  void listenersHearEachReplacementAndEachChangeOfTheMark() {
    ProgramDocument document = ProgramDocument.untitled("a.script", "abc");
    List<String> heard = new ArrayList<>();
    document.addListener(
        new ProgramDocument.Listener() {
          @Override
          public void textChanged(int offset, int removed, String added) {
            heard.add(offset + " -" + removed + " +" + added);
          }

          @Override
          public void fileChanged() {
            heard.add("mark " + document.modified());
          }
        });
    document.replace(1, 1, "XY");
    document.replace(0, 0, "!");
    document.setText("abc");
    assertEquals(List.of("1 -1 +XY", "mark true", "0 -0 +!", "0 -5 +abc", "mark false"), heard);
  }

  @Test
  void aProgramOfPolyScopeXIsATreeThatIsOnlyRead() throws IOException {
    Path file = folder.resolve("Pick.URPX");
    Files.writeString(
        file,
        """
        {"application": {"urscript": {"script": "reset_world_model()"}},
         "program": {"programContent": {}, "urscript": {"script": "x = 1"}}}
        """);
    ProgramDocument document = ProgramDocument.of(SavedProgram.read(file));
    assertTrue(document.isTree());
    assertTrue(document.readOnly());
    assertEquals("Pick", document.bareName());
    assertEquals("Pick.script", document.script().name());
    assertTrue(document.text().startsWith("pendant program 1"), document.text());
    assertEquals(
        List.of(
            "the script that sets up the robot is suppressed, as it needs functions of PolyScope"
                + " X: reset_world_model"),
        document.onDisk().orElseThrow().remarks());
    assertEquals(
        file
            + ": programs of PolyScope X are read and not written; must be called .pendant or"
            + " .script",
        assertThrows(IOException.class, () -> document.toSave().orElseThrow().write())
            .getMessage());
    assertTrue(Files.readString(file).startsWith("{\"application\""));
    SavedProgram copy = document.toSaveAs(folder.resolve("mine.pendant"));
    copy.write();
    document.saved(copy);
    assertFalse(document.readOnly());
  }

  @Test
  void aBrokenProgramOfPolyScopeXIsRefusedWithItsPlace() throws IOException {
    Path file = folder.resolve("pick.urpx");
    Files.writeString(file, "{\n  \"program\": }");
    String message = assertThrows(IOException.class, () -> SavedProgram.read(file)).getMessage();
    assertTrue(message.startsWith(file + ":2:14: is no JSON: "), message);
    Files.writeString(file, "{\"program\": {}, \"application\": {\"urscript\": {}}}");
    assertEquals(
        file + ": was saved without its script, so that nothing can run",
        assertThrows(IOException.class, () -> SavedProgram.read(file)).getMessage());
  }

  @Test
  void savingClearsTheMarkOnlyForWhatWasWritten() throws IOException {
    Path file = folder.resolve("p.script");
    ProgramDocument document = ProgramDocument.untitled("a.script", "one");
    SavedProgram written = SavedProgram.create(file, "one");
    written.write();
    document.replace(3, 0, " more");
    document.saved(written);
    assertEquals("p.script", document.name());
    assertTrue(document.modified());
    assertEquals("one", Files.readString(file));
  }

  @Test
  void bytesThatAreNoUtf8AreKeptAsTheyAre() throws IOException {
    Path file = folder.resolve("latin.script");
    Files.write(file, new byte[] {'#', (byte) 0xE9, '\n'});
    SavedProgram read = SavedProgram.read(file);
    assertEquals("#\u00e9\n", read.text());
    read.withText("#\u00e9!\n").write();
    assertEquals("#\u00e9!\n", new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1));
    assertEquals(
        file
            + ": it is written in ISO-8859-1, which lacks some of the characters; Save as writes"
            + " UTF-8",
        assertThrows(IOException.class, read.withText("\u2265")::write).getMessage());
  }

  @Test
  void savingAsKeepsCharsetAndLineEnds() throws IOException {
    Path file = folder.resolve("latin.script");
    Files.write(file, "#\u00e9\r\n".getBytes(StandardCharsets.ISO_8859_1));
    ProgramDocument document = ProgramDocument.of(SavedProgram.read(file));
    Path other = folder.resolve("other.script");
    document.toSaveAs(other).write();
    assertEquals(-1, Files.mismatch(file, other));
    document.replace(1, 1, "\u2265");
    document.toSaveAs(other).write();
    assertEquals("#\u2265\r\n", Files.readString(other));
  }

  private static String refusal(Path file) {
    return assertThrows(IOException.class, () -> SavedProgram.read(file)).getMessage();
  }

  @Test
  void whatIsNoProgramIsRefusedInWords() throws IOException {
    Path none = folder.resolve("none.script");
    assertEquals(none + ": there is no such file", refusal(none));
    assertEquals(folder + ": it is a folder", refusal(folder));
    Path binary = folder.resolve("a.bin");
    Files.write(binary, new byte[] {'a', 0, 1});
    assertEquals(binary + ": it is no text, byte 2 is 0", refusal(binary));
    Path huge = folder.resolve("huge.script");
    try (RandomAccessFile sparse = new RandomAccessFile(huge.toFile(), "rw")) {
      sparse.setLength(33L << 20);
    }
    assertEquals(huge + ": it has 33 MiB, a program may have at most 32 MiB", refusal(huge));
  }

  @Test
  void aProgramWhoseFileIsGoneIsModifiedUntilItIsSaved() throws IOException {
    SavedProgram file = SavedProgram.create(folder.resolve("p.script"), "one");
    file.write();
    ProgramDocument document = ProgramDocument.of(SavedProgram.read(file.path()));
    DiskChange change = new DiskChange();
    assertFalse(change.gone(file), "before it was ever seen");
    assertEquals(Optional.empty(), change.look(file));
    Files.delete(file.path());
    assertTrue(change.gone(file));
    assertFalse(change.gone(file), "told once");
    document.gone();
    assertTrue(document.modified());
    file.write();
    assertEquals(Optional.of(file), change.look(file), "back again");
    document.saved(file);
    assertFalse(document.modified());
  }

  @Test
  void lineEndsAreWrittenAsTheyWereRead() throws IOException {
    Path file = folder.resolve("dos.script");
    Files.writeString(file, "a\r\nb\r\n");
    SavedProgram read = SavedProgram.read(file);
    assertEquals("a\nb\n", read.text());
    read.withText("a\nc\n").write();
    assertEquals("a\r\nc\r\n", Files.readString(file));
  }

  @Test
  void mixedLineEndsAreLeftAlone() {
    assertEquals(
        "a\r\nb\n", SavedProgram.of(folder, "a\r\nb\n".getBytes(StandardCharsets.UTF_8)).text());
  }

  @Test
  void aFileThatMayNotBeWrittenStaysAsItWas() throws IOException {
    Path file = folder.resolve("here");
    Files.createDirectory(file);
    assertThrows(IOException.class, SavedProgram.create(file, "x")::write);
    assertTrue(Files.isDirectory(file));
    try (var left = Files.list(folder)) {
      assertEquals(List.of(file), left.toList());
    }
  }

  @Test
  void aChangeOnDiskIsNoticedOnce() throws IOException {
    Path file = folder.resolve("p.script");
    SavedProgram known = SavedProgram.create(file, "one");
    known.write();
    DiskChange change = new DiskChange();
    assertEquals(Optional.empty(), change.look(known));
    Files.writeString(file, "other");
    Files.setLastModifiedTime(file, FileTime.fromMillis(12345));
    assertEquals("other", change.look(known).orElseThrow().text());
    assertEquals(Optional.empty(), change.look(known));
    Files.delete(file);
    assertEquals(Optional.empty(), change.look(known));
  }

  @Test
  void theLastProgramThatIsClosedIsReplaced() {
    ProgramDocument first = ProgramDocument.untitled("first", "");
    ProgramDocument second = ProgramDocument.untitled("second", "");
    ProgramDocument spare = ProgramDocument.untitled("spare", "");
    Programs programs = new Programs(first);
    programs.select(second);
    programs.close(second, spare);
    assertEquals(first, programs.current());
    programs.close(first, spare);
    assertEquals(List.of(spare), programs.all());
    assertEquals(spare, programs.current());
  }

  @Test
  void aTreeIsKnownByTheEndingOfItsFileAndHasAScriptOfItsOwn() {
    ProgramDocument script = ProgramDocument.untitled("a.script", "text");
    assertFalse(script.isTree());
    assertSame(script, script.script());
    ProgramDocument tree = ProgramDocument.untitled("a.pendant", "text");
    assertTrue(tree.isTree());
    assertSame(tree.script(), tree.script());
    assertFalse(tree.script().isTree());
    assertEquals("a.script", tree.script().name());
  }

  @Test
  void theScriptOfATreeIsNamedBesideTheFileOfTheTree() {
    ProgramDocument tree =
        ProgramDocument.of(SavedProgram.create(Path.of("folder", "cell.pendant"), "text"));
    assertEquals(Path.of("folder", "cell.script").toString(), tree.script().source().name());
    tree.saved(SavedProgram.create(Path.of("other", "b.pendant"), "text"));
    assertEquals("b.script", tree.script().name());
    assertEquals("", tree.script().text());
  }
}
