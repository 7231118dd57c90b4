package org.pendant.controller.eip;

import java.util.function.DoubleSupplier;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Reply;

/** Handler of the commands about configured assemblies. */
public final class AssemblyCommandHandler implements CommandHandler<AssemblyCommand> {
  private final Assemblies assemblies;
  private final DoubleSupplier timeS;

  /**
   * For the assemblies of one box.
   *
   * @param timeS robot time, s
   */
  public AssemblyCommandHandler(Assemblies assemblies, DoubleSupplier timeS) {
    this.assemblies = assemblies;
    this.timeS = timeS;
  }

  @Override
  public Class<AssemblyCommand> family() {
    return AssemblyCommand.class;
  }

  @Override
  public Reply carryOut(AssemblyCommand command) {
    return switch (command) {
      case AssemblyCommand.ConfigureAssemblies(AssemblyPair pair) ->
          Reply.unless(assemblies.configure(pair));
      case AssemblyCommand.ReceiveAssembly(int instance, AssemblyData data) ->
          Reply.unless(assemblies.received(instance, data, timeS.getAsDouble()));
    };
  }
}
