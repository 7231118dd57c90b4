package org.pendant.sweep.run;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Operator;
import org.pendant.controller.world.Scene;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmDescription;
import org.pendant.sweep.plan.RunSettings;
import org.pendant.sweep.plan.SweepPlan;

/**
 * Job inputs: all that a plan names, read.
 *
 * @param program what runs, before any variant changes it
 * @param nodes where its lines are in the tree that it is made of; empty for scripts
 * @param folder from which programs read files
 * @param robot name of the arm where no parameter says otherwise
 * @param arms all arms that variants have, by name, with their calibration
 * @param installation how the robot is set up
 * @param scene what is around the arm
 * @param equipment what answers the program
 * @param signals inputs from the start
 */
record JobInputs(
    SweepPlan plan,
    Source program,
    Optional<ProgramNodes> nodes,
    ProgramsFolder folder,
    String robot,
    Map<String, ArmDescription> arms,
    Optional<Installation> installation,
    Scene scene,
    CellEquipment equipment,
    List<SignalWrite> signals) {
  JobInputs {
    arms = Map.copyOf(arms);
    signals = List.copyOf(signals);
  }

  /** What a controller is switched on with that differs in nothing. */
  ControllerOptions options(String arm, Optional<Installation> installed) {
    RunSettings settings = plan.settings();
    ControllerOptions options =
        ControllerOptions.headless()
            .withRobot(arms.get(arm))
            .withCalibration(arms.get(arm).calibration())
            .withOperator(Operator.headless(List.of()))
            .withArm(settings.idealArm() ? ArmChoice.IDEAL : ArmChoice.DYNAMIC)
            .withMeasuredNoise(settings.measuredNoise())
            .withStartRamp(settings.startRamp())
            .withEquipment(equipment)
            .withProgramsFolder(folder);
    return installed.isPresent() ? options.withInstallation(installed.get()) : options;
  }
}
