/**
 * The robot behind a debug session: one controller, driven by one thread. {@link
 * org.pendant.editors.dap.run.RobotRun} is the class to open first.
 */
package org.pendant.editors.dap.run;
