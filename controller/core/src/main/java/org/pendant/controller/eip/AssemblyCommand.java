package org.pendant.controller.eip;

import org.pendant.controller.command.Command;

/** Command of an EtherNet/IP scanner about configured assemblies. */
public sealed interface AssemblyCommand extends Command {

  /**
   * Makes the assemblies of an EtherNet/IP connection (manual 21.1.1); refused when one of them
   * exists with another size or in another pair.
   */
  record ConfigureAssemblies(AssemblyPair pair) implements AssemblyCommand {}

  /**
   * An EtherNet/IP scanner has written an assembly; refused when there is no such instance or it
   * has another size.
   */
  record ReceiveAssembly(int instance, AssemblyData data) implements AssemblyCommand {}
}
