package org.pendant.command;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.identification.DriveFit;
import org.pendant.models.identification.LoadFit;
import org.pendant.recording.compare.Samples;
import org.pendant.recording.fit.ArmFit;

/**
 * Command {@code pendant fit RECORDING...}: estimates friction, payload and delays of an arm from
 * recordings of it.
 */
final class FitCommand implements Subcommand {
  private static final Option OUT =
      Option.output("--out", "FILE.json", "where to write the arm file, for --robot")
          .documented(
              "arm.json",
              "the arm file to be written, which `--robot` takes; without it nothing is written");

  private static final int DIGITS = 4;

  /** Of numbers that the recordings do not tell. */
  private static final String NOT_TOLD = "-";

  @Override
  public String name() {
    return "fit";
  }

  @Override
  public String operands() {
    return "RECORDING...";
  }

  @Override
  public String summary() {
    return "estimate friction, payload and delays of an arm from recordings";
  }

  @Override
  public List<Option> options() {
    return Stream.concat(
            Stream.of(RunOptions.ROBOT, OUT, OutputFile.FORCE, RecordedFile.FREQUENCY),
            PayloadOptions.ALL.stream())
        .toList();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().isEmpty()) {
      throw new UsageException("expected one recording or more, there is none");
    }
    ArmDescription model = RobotName.model(arguments);
    PayloadOptions payload = PayloadOptions.of(arguments);
    List<Path> paths = new ArrayList<>();
    for (String name : arguments.operands()) {
      paths.add(arguments.files().path("a recording", name));
    }
    Optional<OutputFile> out = OutputFile.of(OUT, arguments);
    List<RecordedFile> files = new ArrayList<>();
    for (int i = 0; i < paths.size(); i++) {
      RecordedFile file =
          RecordedFile.read(
              arguments.operands().get(i), paths.get(i), arguments.number(RecordedFile.FREQUENCY));
      refuseIfLacking(file);
      file.notes().forEach(note -> console.print("note: " + file.name() + ": " + note));
      files.add(file);
    }
    List<Samples> recordings = files.stream().map(RecordedFile::samples).toList();
    Samples first = recordings.getFirst();
    Payload assumed = payload(payload.or(first.rows(first.rows() - 1, first.rows())));
    Optional<Payload> given =
        payload.massKg().isPresent() ? Optional.of(assumed) : Optional.empty();
    ArmFit fit = ArmFit.of(model, recordings, given, assumed);
    fit.notes().forEach(note -> console.print("note: " + note));
    print(model, fit, given, console);
    if (out.isPresent()) {
      byte[] bytes =
          ArmFile.text(named(fit.arm(), arguments.operands())).getBytes(StandardCharsets.UTF_8);
      out.get().write(stream -> stream.write(bytes));
    }
    return ExitCode.DONE;
  }

  private static void refuseIfLacking(RecordedFile file) throws UsageException {
    Optional<String> lacks = ArmFit.lacks(List.of(file.samples()));
    if (lacks.isPresent()) {
      throw new UsageException(file.name() + " has no " + lacks.get() + " to be fitted to");
    }
  }

  private static Payload payload(PayloadOptions options) {
    double massKg = options.massKg().orElse(0);
    Vector3 cog = options.cogM().orElse(new Vector3(0, 0, 0));
    return massKg > 0 ? Payload.of(massKg, cog.x(), cog.y(), cog.z()) : Payload.NONE;
  }

  private static ArmDescription named(ArmDescription arm, List<String> recordings) {
    List<String> notes = new ArrayList<>(arm.notes());
    notes.add("drives: fitted to " + String.join(", ", recordings));
    return arm.withNotes(notes);
  }

  private static void print(
      ArmDescription model, ArmFit fit, Optional<Payload> given, Console console) {
    if (fit.load().isPresent()) {
      LoadFit.Found load = fit.load().get();
      Payload payload = load.payload();
      console.print(
          (fit.payloadFound()
                  ? "payload: "
                  : given.isPresent() ? "payload, as given: " : "payload, as recorded: ")
              + number(payload.massKg())
              + " kg at "
              + number(payload.cogXM())
              + ", "
              + number(payload.cogYM())
              + ", "
              + number(payload.cogZM())
              + " m");
      console.print(
          "moments unexplained: "
              + number(load.rmsBeforeNm())
              + " Nm rms before, "
              + number(load.rmsAfterNm())
              + " Nm after");
    }
    Table table =
        new Table()
            .left("joint")
            .left("")
            .right("rotor kg m\u00b2")
            .right("K Nm/A")
            .right("coulomb A")
            .right("curved A")
            .right("over rad/s")
            .right("viscous A s/rad")
            .right("lag ms")
            .right("unexplained A rms");
    for (int i = 0; i < Joints.COUNT; i++) {
      Actuator before = model.actuators().get(i);
      Actuator after = fit.arm().actuators().get(i);
      ArmFit.JointFit found = fit.joints().get(i);
      Optional<DriveFit> drive = found.drive();
      boolean constant = drive.isPresent() && drive.get().torqueConstantFound();
      table.row(
          RobotSheet.JOINTS.get(i),
          "before",
          number(before.rotorInertiaKgM2()),
          number(before.torqueConstantNmPerA()),
          number(before.friction().coulombA()),
          number(before.friction().curvedA()),
          number(before.friction().curveSpeedRadPerS()),
          number(before.friction().viscousASPerRad()),
          number(1000 * before.lagS()),
          drive.isPresent() ? number(drive.get().rmsBeforeA()) : "");
      table.row(
          "",
          "fitted",
          found.rotorInertiaKgM2().isPresent() ? number(after.rotorInertiaKgM2()) : NOT_TOLD,
          constant ? number(after.torqueConstantNmPerA()) : NOT_TOLD,
          drive.isPresent() ? number(after.friction().coulombA()) : NOT_TOLD,
          drive.isPresent() ? number(after.friction().curvedA()) : NOT_TOLD,
          drive.isPresent() ? number(after.friction().curveSpeedRadPerS()) : NOT_TOLD,
          drive.isPresent() ? number(after.friction().viscousASPerRad()) : NOT_TOLD,
          found.lagS().isPresent() ? number(1000 * after.lagS()) : NOT_TOLD,
          drive.isPresent() ? number(drive.get().rmsAfterA()) : NOT_TOLD);
    }
    console.print("");
    table.aligned().forEach(console::print);
  }

  private static String number(double value) {
    return Decimal.text(value, DIGITS);
  }
}
