package org.pendant.kit.fault;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class FaultFileTest {
  @TempDir Path folder;

  private Path file;
  private FaultFile faults;

  @BeforeEach
  void openFile() {
    file = folder.resolve("own/errors.txt");
    faults = new FaultFile(file);
  }

  @Test
  void theFirstOfAKindIsToldAndWrittenWithItsCauseAndPlace() throws IOException {
    String told = faults.add("background", fault("no such joint")).orElseThrow();
    assertTrue(told.contains("no such joint"), told);
    assertTrue(told.contains(file.toString()), told);
    String text = Files.readString(file);
    assertTrue(text.contains("thread background"), text);
    assertTrue(text.contains("FaultFileTest.fault"), text);
    assertTrue(text.contains("the cause"), text);
  }

  @Test
  void aFaultThatComesAgainAndAgainIsCountedAndNotWrittenAgain() throws IOException {
    List<String> told = new ArrayList<>();
    for (int i = 0; i < 30 * 3600; i++) {
      faults.add("AWT-EventQueue-0", fault("at frame " + i)).ifPresent(told::add);
    }
    assertEquals(1, told.size(), told::toString);
    assertTrue(Files.readString(file).contains("100000 times so far"));
    assertTrue(Files.size(file) < 20_000, () -> "the file has grown too large");
  }

  @Test
  void faultsAtOtherPlacesAreToldToo() {
    faults.add("a", fault("x"));
    assertTrue(faults.add("a", new IllegalStateException("x")).isPresent());
    assertTrue(faults.add("a", new ArithmeticException("x")).isPresent());
  }

  @Test
  void faultsOfEndlesslyManyKindsEndInOneCount() {
    int told = 0;
    for (int i = 0; i < 2 * FaultFile.MAX_KINDS; i++) {
      IllegalStateException fault = new IllegalStateException();
      fault.setStackTrace(
          new StackTraceElement[] {new StackTraceElement("org.pendant.A", "a", "A.java", i)});
      told += faults.add("a", fault).isPresent() ? 1 : 0;
    }
    assertEquals(FaultFile.MAX_KINDS + 1, told);
  }

  @Test
  void aLargeFileIsPutAsideAndOnlyTheNewestOfThoseIsKept() throws IOException {
    Files.createDirectories(file.getParent());
    Path aside = file.resolveSibling("older-errors.txt");
    Files.writeString(aside, "from last year");
    Files.writeString(file, "x".repeat((int) FaultFile.MAX_BYTES + 1));
    faults.add("a", fault("new"));
    assertTrue(Files.readString(file).contains("new"));
    assertEquals(FaultFile.MAX_BYTES + 1, Files.size(aside));
  }

  @Test
  void aFaultWithoutAPlaceOrWithItselfForACauseDoesNoHarm() {
    RuntimeException bare = new RuntimeException("bare", null) {};
    bare.setStackTrace(new StackTraceElement[0]);
    IllegalStateException first = new IllegalStateException("first");
    IllegalStateException second = new IllegalStateException("second", first);
    first.initCause(second);
    assertTrue(faults.add("a", bare).isPresent());
    assertTrue(faults.add("a", first).isPresent());
  }

  @Test
  void whereTheFileCannotBeWrittenThatIsTold() throws IOException {
    Files.writeString(folder.resolve("own"), "a file where the folder should be");
    Optional<String> told = faults.add("a", fault("x"));
    assertTrue(told.orElseThrow().contains("cannot be written"), told::toString);
  }

  private static RuntimeException fault(String message) {
    return new IllegalStateException(message, new ArithmeticException("the cause"));
  }
}
