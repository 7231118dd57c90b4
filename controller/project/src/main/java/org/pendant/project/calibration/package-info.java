/**
 * Calibrations in files, the programs of PolyScope among them. Open {@link
 * org.pendant.project.calibration.ArmCalibration}.
 */
package org.pendant.project.calibration;
