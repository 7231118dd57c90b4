package org.pendant;

import org.junit.platform.launcher.LauncherSession;
import org.junit.platform.launcher.LauncherSessionListener;

/**
 * Ends the processes that tests have left when the last one is done. A test that was given up
 * leaves its own behind, and the build would wait for the output of those, which is its own, for
 * ever.
 */
public final class LeftProcesses implements LauncherSessionListener {
  @Override
  public void launcherSessionClosed(LauncherSession session) {
    ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
  }
}
