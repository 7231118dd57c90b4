/** Cameras of the cell: what they see of parts, and how programs ask them. */
package org.pendant.controller.device.camera;
