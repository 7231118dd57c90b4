package org.pendant.controller;

/** The next frame is due at once: as fast as the processor goes. */
public final class VirtualClock implements Clock {
  @Override
  public void awaitFrame() throws InterruptedException {
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
  }
}
