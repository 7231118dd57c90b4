/**
 * Calibration: how one arm differs from its model, as files tell it and as measured poses show it.
 * Open {@link org.pendant.models.calibration.CalibrationFile} first.
 */
package org.pendant.models.calibration;
