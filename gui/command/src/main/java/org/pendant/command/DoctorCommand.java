package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.command.doctor.Doctor;
import org.pendant.command.doctor.Finding;
import org.pendant.command.doctor.ProblemReport;
import org.pendant.controller.disk.FileTrouble;

/** Command {@code pendant doctor}: what Pendant finds on this computer, and what to do about it. */
final class DoctorCommand implements Subcommand {
  private static final Option REPORT =
      Option.output("--report", "FILE.zip")
          .documented(
              "problem.zip",
              "write a file to report a problem with: what is printed, the faults that the window"
                  + " has noted, and how the last crashes of the JVM came about. Names of you, your"
                  + " home folder and this computer are replaced; no programs, settings or logs are"
                  + " in it");

  private final Supplier<Doctor> doctor;

  /**
   * The command.
   *
   * @param doctor looks at this computer
   */
  DoctorCommand(Supplier<Doctor> doctor) {
    this.doctor = doctor;
  }

  @Override
  public String name() {
    return "doctor";
  }

  @Override
  public String operands() {
    return "";
  }

  @Override
  public List<Option> options() {
    return List.of(REPORT, OutputFile.FORCE);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (!arguments.operands().isEmpty()) {
      throw new UsageException(text("unexpected", arguments.operands().getFirst()));
    }
    Optional<OutputFile> report = OutputFile.of(REPORT, arguments);
    List<Finding> findings = doctor.get().findings();
    Doctor.lines(findings).forEach(console::print);
    if (report.isPresent()) {
      write(findings, report.get(), console);
    }
    return findings.stream().anyMatch(each -> each.level() == Finding.Level.PROBLEM)
        ? ExitCode.UNAVAILABLE
        : ExitCode.DONE;
  }

  private static void write(List<Finding> findings, OutputFile report, Console console)
      throws UsageException {
    try {
      ProblemReport problem = ProblemReport.of(findings);
      report.write(problem::write);
      console.complain(text("wrote", report.path(), problem.contents()));
    } catch (IOException e) {
      throw new UsageException(text("notedFaultsCannotBeRead", FileTrouble.reason(e)));
    }
  }
}
