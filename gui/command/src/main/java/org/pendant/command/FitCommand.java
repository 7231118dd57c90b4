package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Gravity;
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
      Option.output("--out", "FILE.json")
          .explained("--out.fit")
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
  public List<Option> options() {
    return Stream.concat(
            Stream.of(
                RunOptions.ROBOT,
                CalibrationOption.OPTION,
                InstallationOption.OPTION,
                OUT,
                OutputFile.FORCE,
                RecordedFile.FREQUENCY),
            PayloadOptions.ALL.stream())
        .toList();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().isEmpty()) {
      throw new UsageException(text("recordingsExpected"));
    }
    Optional<Installation> installation = InstallationOption.of(arguments);
    Optional<ArmDescription> named =
        arguments.has(RunOptions.ROBOT)
            ? Optional.of(RobotName.model(arguments))
            : installed(installation);
    CalibrationOption.file(arguments, named);
    PayloadOptions payload = PayloadOptions.of(arguments);
    List<Path> paths = new ArrayList<>();
    for (String name : arguments.operands()) {
      paths.add(arguments.files().path("aRecording", name));
    }
    Optional<OutputFile> out = OutputFile.of(OUT, arguments);
    List<RecordedFile> files = new ArrayList<>();
    for (int i = 0; i < paths.size(); i++) {
      RecordedFile file =
          RecordedFile.read(
              arguments.operands().get(i), paths.get(i), arguments.number(RecordedFile.FREQUENCY));
      refuseIfLacking(file);
      file.notes().forEach(note -> console.print(text("noteOf", file.name(), note)));
      files.add(file);
    }
    InstallationOption.tell(arguments, console);
    ArmDescription model = arm(arguments, named, installation, files);
    Gravity gravity = gravity(installation, files);
    List<Samples> recordings = files.stream().map(RecordedFile::samples).toList();
    Samples first = recordings.getFirst();
    Payload assumed = payload(payload.or(first.rows(first.rows() - 1, first.rows())));
    Optional<Payload> given =
        payload.massKg().isPresent() ? Optional.of(assumed) : Optional.empty();
    ArmFit fit = ArmFit.of(model, gravity, recordings, given, assumed);
    fit.notes().forEach(note -> console.print(text("noteIs", note)));
    print(model, fit, given, console);
    if (out.isPresent()) {
      byte[] bytes =
          ArmFile.text(named(fit.arm(), arguments.operands())).getBytes(StandardCharsets.UTF_8);
      out.get().write(stream -> stream.write(bytes));
    }
    return ExitCode.DONE;
  }

  private static Optional<ArmDescription> installed(Optional<Installation> installation) {
    return installation.map(Installation::robot).flatMap(ArmLibrary::find).map(ArmLibrary::load);
  }

  /**
   * The arm to begin with: the one that is named, or else that of the recordings, with its
   * calibration.
   */
  private static ArmDescription arm(
      Arguments arguments,
      Optional<ArmDescription> named,
      Optional<Installation> installation,
      List<RecordedFile> files)
      throws UsageException {
    Optional<ArmDescription> recorded = Optional.empty();
    for (RecordedFile each : files) {
      if (named.isEmpty() && each.arm().isPresent()) {
        ArmDescription arm = each.arm().get();
        if (recorded.isPresent() && !recorded.get().equals(arm)) {
          throw new UsageException(text("anotherArm", each.name(), RunOptions.ROBOT.usage()));
        }
        recorded = Optional.of(arm);
      }
    }
    ArmDescription model =
        named.orElse(
            recorded
                .map(each -> each.withCalibration(Calibration.NONE))
                .orElse(ArmLibrary.load(ControllerOptions.DEFAULT_ROBOT)));
    Calibration calibration = CalibrationOption.of(arguments, installation, model);
    return model.withCalibration(
        calibration.equals(Calibration.NONE)
            ? recorded.map(ArmDescription::calibration).orElse(Calibration.NONE)
            : calibration);
  }

  /** As the installation says that the arm is mounted, or else as recordings do; upright else. */
  private static Gravity gravity(Optional<Installation> installation, List<RecordedFile> files)
      throws UsageException {
    if (installation.isPresent()) {
      Vector3 felt = installation.get().mounting().gravityInBaseMPerS2();
      return new Gravity(felt.x(), felt.y(), felt.z());
    }
    List<Gravity> told =
        files.stream().flatMap(each -> each.gravity().stream()).distinct().toList();
    if (told.size() > 1) {
      throw new UsageException(text("mountedDifferently", InstallationOption.OPTION.usage()));
    }
    return told.isEmpty() ? Gravity.UPRIGHT : told.getFirst();
  }

  private static void refuseIfLacking(RecordedFile file) throws UsageException {
    Optional<String> lacks = ArmFit.lacks(List.of(file.samples()));
    if (lacks.isPresent()) {
      throw new UsageException(text("lacksColumns", file.name(), lacks.get()));
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
          text(
              fit.payloadFound()
                  ? "payloadFound"
                  : given.isPresent() ? "payloadGiven" : "payloadRecorded",
              number(payload.massKg()),
              number(payload.cogXM()),
              number(payload.cogYM()),
              number(payload.cogZM())));
      console.print(
          text("momentsUnexplained", number(load.rmsBeforeNm()), number(load.rmsAfterNm())));
    }
    Table table =
        new Table()
            .left(text("joint"))
            .left("")
            .right(text("rotorHead"))
            .right("K Nm/A")
            .right(text("coulombHead"))
            .right(text("curvedHead"))
            .right(text("overHead"))
            .right(text("viscousHead"))
            .right(text("lagHead"))
            .right(text("unexplainedHead"));
    for (int i = 0; i < Joints.COUNT; i++) {
      Actuator before = model.actuators().get(i);
      Actuator after = fit.arm().actuators().get(i);
      ArmFit.JointFit found = fit.joints().get(i);
      Optional<DriveFit> drive = found.drive();
      boolean constant = drive.isPresent() && drive.get().torqueConstantFound();
      table.row(
          CommandLanguage.shown(RobotSheet.JOINTS.get(i)),
          text("before"),
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
          text("fitted"),
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
