package org.pendant.protocols.eip.service;

import org.pendant.controller.eip.AssemblyPair;

/** Configuration that the service works on. */
public interface Configuration {
  /** Makes the assemblies of a pair; answers whether they are there. Waits for the next frame. */
  boolean add(AssemblyPair pair) throws InterruptedException;

  /** Whether a scanner is connected that writes the instance. */
  boolean connected(int fromScanner);
}
