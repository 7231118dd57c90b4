package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationFile;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.calibration.MeasuredPoses;
import org.pendant.models.kinematics.CalibrationEstimate;
import org.pendant.models.kinematics.MeasuredPose;
import org.pendant.models.kinematics.NominalDeviation;
import org.pendant.models.kinematics.PoseResiduals;

/** Command {@code pendant calibrate FILE.csv}: estimates a calibration from measured poses. */
final class CalibrateCommand implements Subcommand {
  private static final Option OUT =
      Option.output("--out", "FILE.conf")
          .explained("--out.calibrate")
          .documented("arm.conf", "where to write the calibration; standard output without it");

  @Override
  public String name() {
    return "calibrate";
  }

  @Override
  public String operands() {
    return "FILE.csv";
  }

  @Override
  public List<Option> options() {
    return List.of(RunOptions.ROBOT, OUT, OutputFile.FORCE);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().size() != 1) {
      throw new UsageException(text("onePosesFileExpected", arguments.operands().size()));
    }
    String name = arguments.operands().getFirst();
    ArmDescription model = RobotName.model(arguments);
    byte[] table = arguments.files().bytes("theFileOfPoses", name);
    Optional<OutputFile> out = OutputFile.of(OUT, arguments);
    List<MeasuredPose> measured = measured(name, table);
    CalibrationEstimate.Result.Estimated found =
        switch (CalibrationEstimate.of(model, measured)) {
          case CalibrationEstimate.Result.Estimated estimated -> estimated;
          case CalibrationEstimate.Result.Refused refused ->
              throw new UsageException(name + " " + CommandLanguage.shown(refused.reason()));
        };
    Calibration calibration = Calibration.of(found.deltas());
    ArmDescription arm = model.withCalibration(calibration);
    Optional<String> refusal = NominalDeviation.refusal(arm);
    if (refusal.isPresent()) {
      throw new UsageException(text("calibrationFrom", name, refusal.get()));
    }
    List<String> report =
        List.of(
            String.format(
                Locale.ROOT,
                text("posesAndCondition"),
                model.displayName(),
                measured.size(),
                found.condition()),
            text("residualsBefore", shown(PoseResiduals.of(model, measured))),
            text("residualsAfter", shown(PoseResiduals.of(arm, measured))));
    StringBuilder text = new StringBuilder();
    report.forEach(each -> text.append("# ").append(each).append('\n'));
    text.append(CalibrationFile.text(calibration));
    if (out.isPresent()) {
      report.forEach(console::print);
      byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
      out.get().write(stream -> stream.write(bytes));
    } else {
      console.print(text.toString().stripTrailing());
    }
    return ExitCode.DONE;
  }

  private static List<MeasuredPose> measured(String name, byte[] table) throws UsageException {
    try {
      return MeasuredPoses.read(name, table);
    } catch (CalibrationTrouble e) {
      throw UsageException.fromEnglish(e);
    }
  }

  private static String shown(PoseResiduals residuals) {
    return String.format(
        Locale.ROOT,
        text("meanAndMax"),
        1000 * residuals.meanM(),
        1000 * residuals.maxM(),
        1000 * residuals.meanRad(),
        1000 * residuals.maxRad());
  }
}
