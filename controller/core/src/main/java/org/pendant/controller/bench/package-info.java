/** Test bench: what a test of a robot program sets up and asks beyond the control box itself. */
package org.pendant.controller.bench;
