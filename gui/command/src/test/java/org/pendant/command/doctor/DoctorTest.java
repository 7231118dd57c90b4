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
            PlainFindings.ok("Java", "25.0.3"),
            PlainFindings.problem("Port 30004", "taken by nc, process 4711", "end that program")));
  }

  @Test
  void columnsStandBelowEachOtherWhereChineseCharactersAreTwoColumnsWide() {
    FindingText port = new FindingText("Port 30004", "\u7aef\u53e3 30004");

    assertEquals(
        List.of("ok      Java          25", "ok      \u7aef\u53e3 30004    nc"),
        linesOf(PlainFindings.ok("Java", "25"), Finding.ok(port, FindingText.of("nc")))
            .subList(0, 2));
  }

  @Test
  void problemsAndNotesAreCounted() {
    Finding note = PlainFindings.note("Display", "there is none", "the window does not open");

    Finding problem = PlainFindings.problem("Logs", "/x is read-only", "change that");

    assertEquals("no problems, 2 notes", linesOf(note, note).getLast());
    assertEquals("2 problems, 1 note", linesOf(problem, note, problem).getLast());
    assertEquals("no problems, no notes", linesOf(PlainFindings.ok("Java", "25")).getLast());
  }
}
