package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.doctor.Doctor;
import org.pendant.command.doctor.Finding;
import org.pendant.command.doctor.PlainFindings;

final class DoctorCommandTest {
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @TempDir private Path folder;

  private ExitCode doctor(Finding finding, String... words) throws UsageException {
    DoctorCommand command = new DoctorCommand(() -> Doctor.of(() -> List.of(finding)));
    Console console = new Console(output, errors);
    ExitCode code = command.run(Arguments.parse(command.options(), List.of(words)), console);
    console.flush();
    return code;
  }

  @Test
  void notesAreNoFailure() throws UsageException {
    assertEquals(ExitCode.DONE, doctor(PlainFindings.note("Display", "none", "no window")));
    assertTrue(output.toString(StandardCharsets.UTF_8).contains("no problems, 1 note"));
  }

  @Test
  void problemsEndWithWhatIsUnavailable() throws UsageException {
    assertEquals(
        ExitCode.UNAVAILABLE,
        doctor(PlainFindings.problem("Logs", "/x is read-only", "change that")));
  }

  @Test
  void reportIsWritten() throws UsageException {
    Path file = folder.resolve("problem.zip");

    doctor(PlainFindings.ok("Java", "25"), "--report", file.toString());

    assertTrue(Files.exists(file));
    assertTrue(errors.toString(StandardCharsets.UTF_8).contains("problem.zip: doctor.txt"));
  }

  @Test
  void reportReplacesNothingUnasked() throws UsageException {
    String file = folder.resolve("problem.zip").toString();
    doctor(PlainFindings.ok("Java", "25"), "--report", file);

    UsageException refusal =
        assertThrows(
            UsageException.class, () -> doctor(PlainFindings.ok("Java", "25"), "--report", file));

    assertTrue(refusal.getMessage().contains("exists already"), refusal.getMessage());
    assertEquals(
        ExitCode.DONE, doctor(PlainFindings.ok("Java", "25"), "--report", file, "--force"));
  }

  @Test
  void operandsAreRefused() {
    assertThrows(UsageException.class, () -> doctor(PlainFindings.ok("Java", "25"), "all"));
  }
}
