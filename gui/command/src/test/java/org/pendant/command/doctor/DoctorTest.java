package org.pendant.command.doctor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class DoctorTest {

  private static List<String> linesOf(Finding... findings) {
    Doctor doctor = Doctor.of(() -> List.of(findings));
    List<String> lines = Doctor.lines(doctor.findings());
    assertTrue(lines.getFirst().startsWith("pendant "), lines::toString);
    return lines.subList(2, lines.size());
  }

  @Test
  void findingHasItsAdviceBelow() {
    assertEquals(
        List.of(
            "ok      Java          25.0.3",
            "problem Port 30004    taken by nc, process 4711",
            "                      end that program",
            "",
            "1 problem, no notes"),
        linesOf(
            Finding.ok("Java", "25.0.3"),
            Finding.problem("Port 30004", "taken by nc, process 4711", "end that program")));
  }

  @Test
  void problemsAndNotesAreCounted() {
    Finding note = Finding.note("Display", "there is none", "the window does not open");

    assertEquals("no problems, 2 notes", linesOf(note, note).getLast());
    assertEquals("no problems, no notes", linesOf(Finding.ok("Java", "25")).getLast());
  }
}
