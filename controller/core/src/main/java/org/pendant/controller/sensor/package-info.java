/**
 * Readings of the arm's sensors, whatever arm it is: what safety functions and state look at. Open
 * {@link org.pendant.controller.sensor.ArmSensors}, there is nothing else.
 */
package org.pendant.controller.sensor;
