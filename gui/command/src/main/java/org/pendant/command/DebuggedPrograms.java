package org.pendant.command;

import java.util.List;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.DebugTargets;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.externalcontrol.NoScript;

/** Debugged programs: what an editor debugs, with the options of {@code pendant run}. */
final class DebuggedPrograms implements DebugTargets {
  @Override
  public DebugTarget target(String program, List<String> options) throws TargetRefusal {
    try {
      Arguments arguments = Arguments.parse(RunOptions.OF_DEBUGGING, options);
      if (!arguments.operands().isEmpty()) {
        throw new TargetRefusal(
            "args has " + arguments.operands().getFirst() + ", which is no option");
      }
      RunnableFile read = RunnableFile.read(arguments, List.of(program)).getFirst();
      RunOptions asked = RunOptions.of(arguments, read.installation(), read.robot());
      RunnableFile whole = read.asked(asked.drivers());
      ScriptConnectors connectors = new ScriptConnectors(asked.hosts());
      return new DebugTarget(
          program,
          whole.source(),
          whole.tree().isPresent(),
          whole::nodeAt,
          whole.notes(),
          whole.problems(),
          asked.controller().withOutside(connectors.connectors()),
          asked.waveforms(),
          asked::clock,
          connectors::close);
    } catch (UsageException | NoScript e) {
      throw new TargetRefusal(String.valueOf(e.getMessage()));
    }
  }
}
