package org.pendant.controller;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.device.plc.AdapterPort;
import org.pendant.controller.device.plc.ScannerOutputs;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.rtde.ControlAssembly;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;

/**
 * Cell adapter: the built-in EtherNet/IP assemblies for scanners of the cell. They take and write
 * inputs as scanners at the port do, and are lost as these are.
 */
final class CellAdapter implements AdapterPort {
  private final ControlBox box;
  private final RtdeCommandHandler inputs;
  private final InstallationHandler installed;
  private final Supplier<ControllerState> state;
  private ScannerOutputs written = new ScannerOutputs(0, List.of(), OptionalDouble.empty());
  private InputUpdate update =
      new InputUpdate(
          ControlAssembly.RECIPE, List.of(), OptionalDouble.empty(), Optional.empty(), List.of());

  /** What {@link #written} is in the assembly. */
  private AssemblyData bytes = AssemblyData.zero(ControlAssembly.BYTES);

  CellAdapter(ControlBox box, InstallationHandler installed, Supplier<ControllerState> state) {
    this.box = box;
    this.installed = installed;
    this.state = state;
    inputs = new RtdeCommandHandler(box);
  }

  @Override
  public Optional<String> claim(String owner) {
    InputOwners owners = box.signals().owners();
    Optional<String> other =
        ControlAssembly.RECIPE.claims().stream()
            .flatMap(each -> owners.refusal(each, owner).stream())
            .map(Refusal::text)
            .findFirst();
    if (other.isEmpty()) {
      ControlAssembly.RECIPE.claims().forEach(each -> owners.claim(each, owner));
    }
    return other;
  }

  @Override
  public void write(String owner, ScannerOutputs outputs) {
    if (!outputs.equals(written)) {
      written = outputs;
      bytes = ControlAssembly.encode(outputs.bits(), outputs.words(), outputs.speedFraction());
      update =
          new InputUpdate(
              ControlAssembly.RECIPE,
              registers(outputs),
              outputs.speedFraction(),
              Optional.empty(),
              List.of());
    }
    if (inputs.write(owner, update).isEmpty()) {
      box.links().assemblies().writeBuiltIn(bytes);
    }
  }

  /** A scanner writes all registers of the assembly; floats, which have no signals, as zero. */
  private static List<SignalWrite> registers(ScannerOutputs outputs) {
    List<SignalWrite> writes = new ArrayList<>();
    for (int i = 0; i < Long.SIZE; i++) {
      boolean bit = (outputs.bits() >> i & 1) != 0;
      writes.add(new SignalWrite.BooleanRegister(RegisterDirection.INPUT, i, bit));
    }
    for (int i = 0; i < outputs.words().size(); i++) {
      int word = outputs.words().get(i);
      writes.add(new SignalWrite.IntegerRegister(RegisterDirection.INPUT, i, word));
      writes.add(new SignalWrite.FloatRegister(RegisterDirection.INPUT, i, 0));
    }
    return writes;
  }

  @Override
  public void lost(String owner) {
    installed.scannerLost(owner);
    box.signals().owners().release(owner);
  }

  @Override
  public boolean outputBit(int address) {
    return outputs().bool(address);
  }

  @Override
  public int outputWord(int address) {
    return outputs().integer(address);
  }

  private RegisterLevels outputs() {
    return state.get().signals().outputs();
  }

  @Override
  public int robotMode() {
    return state.get().safety().robotMode().code();
  }

  @Override
  public int robotStatus() {
    return RobotBits.robotStatus(state.get());
  }

  @Override
  public int safetyMode() {
    return RobotBits.coarse(state.get().safety().safetyMode()).code();
  }

  @Override
  public int safetyStatus() {
    return RobotBits.safetyStatus(state.get());
  }
}
