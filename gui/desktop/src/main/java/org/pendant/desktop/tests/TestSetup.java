package org.pendant.desktop.tests;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.testing.TestId;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.TestSources;

/**
 * Test setup: where tests are, and the robot that each has of its own.
 *
 * @param files of the tests and of what they test
 * @param robot what the controller of each test is switched on with
 */
record TestSetup(Files files, ControllerOptions robot) {

  /** The files below a folder; any thread may ask. */
  interface Files extends TestSources {
    /** The name of the folder, for people. */
    String folder();

    /**
     * The names of the files of tests, sorted.
     *
     * @throws IOException if a folder cannot be read; its message says which
     */
    List<String> find() throws IOException;

    /**
     * What tests are compared with that ask for it.
     *
     * @param update whether it is recorded anew instead
     */
    Goldens goldens(boolean update);

    /** What differed first where a test was compared; empty where nothing did that has a curve. */
    Optional<TrackCurves> difference(TestId test);

    /** Whether a file of that name was read. */
    boolean hasRead(String name);
  }
}
