/// The functions of the standard that no FMU of dynamY serves: a library has all functions, and a
/// program that calls one of these gets an error. They take no arguments but the instance: those that
/// follow are the caller's, in registers and on its stack.
#include "fmu/fmi3_handle.hpp"

using namespace dynamy::fmi3;

#pragma GCC visibility push(default)
extern "C" {

// Other kinds of FMUs.
Instance fmi3InstantiateModelExchange() { return nullptr; }
Instance fmi3InstantiateScheduledExecution() { return nullptr; }
Status fmi3EnterContinuousTimeMode(Instance i) {
  return unserved(i, "fmi3EnterContinuousTimeMode");
}
Status fmi3CompletedIntegratorStep(Instance i) {
  return unserved(i, "fmi3CompletedIntegratorStep");
}
Status fmi3SetTime(Instance i) { return unserved(i, "fmi3SetTime"); }
Status fmi3SetContinuousStates(Instance i) { return unserved(i, "fmi3SetContinuousStates"); }
Status fmi3GetContinuousStateDerivatives(Instance i) {
  return unserved(i, "fmi3GetContinuousStateDerivatives");
}
Status fmi3GetEventIndicators(Instance i) { return unserved(i, "fmi3GetEventIndicators"); }
Status fmi3GetContinuousStates(Instance i) { return unserved(i, "fmi3GetContinuousStates"); }
Status fmi3GetNominalsOfContinuousStates(Instance i) {
  return unserved(i, "fmi3GetNominalsOfContinuousStates");
}
Status fmi3GetNumberOfEventIndicators(Instance i) {
  return unserved(i, "fmi3GetNumberOfEventIndicators");
}
Status fmi3GetNumberOfContinuousStates(Instance i) {
  return unserved(i, "fmi3GetNumberOfContinuousStates");
}
Status fmi3ActivateModelPartition(Instance i) { return unserved(i, "fmi3ActivateModelPartition"); }

// Types that no variable has.
Status fmi3GetFloat32(Instance i) { return unserved(i, "fmi3GetFloat32"); }
Status fmi3GetInt8(Instance i) { return unserved(i, "fmi3GetInt8"); }
Status fmi3GetUInt8(Instance i) { return unserved(i, "fmi3GetUInt8"); }
Status fmi3GetInt16(Instance i) { return unserved(i, "fmi3GetInt16"); }
Status fmi3GetUInt16(Instance i) { return unserved(i, "fmi3GetUInt16"); }
Status fmi3GetInt32(Instance i) { return unserved(i, "fmi3GetInt32"); }
Status fmi3GetUInt32(Instance i) { return unserved(i, "fmi3GetUInt32"); }
Status fmi3GetUInt64(Instance i) { return unserved(i, "fmi3GetUInt64"); }
Status fmi3GetBoolean(Instance i) { return unserved(i, "fmi3GetBoolean"); }
Status fmi3GetString(Instance i) { return unserved(i, "fmi3GetString"); }
Status fmi3GetBinary(Instance i) { return unserved(i, "fmi3GetBinary"); }
Status fmi3GetClock(Instance i) { return unserved(i, "fmi3GetClock"); }
Status fmi3SetFloat32(Instance i) { return unserved(i, "fmi3SetFloat32"); }
Status fmi3SetInt8(Instance i) { return unserved(i, "fmi3SetInt8"); }
Status fmi3SetUInt8(Instance i) { return unserved(i, "fmi3SetUInt8"); }
Status fmi3SetInt16(Instance i) { return unserved(i, "fmi3SetInt16"); }
Status fmi3SetUInt16(Instance i) { return unserved(i, "fmi3SetUInt16"); }
Status fmi3SetInt32(Instance i) { return unserved(i, "fmi3SetInt32"); }
Status fmi3SetUInt32(Instance i) { return unserved(i, "fmi3SetUInt32"); }
Status fmi3SetUInt64(Instance i) { return unserved(i, "fmi3SetUInt64"); }
Status fmi3SetBoolean(Instance i) { return unserved(i, "fmi3SetBoolean"); }
Status fmi3SetString(Instance i) { return unserved(i, "fmi3SetString"); }
Status fmi3SetBinary(Instance i) { return unserved(i, "fmi3SetBinary"); }
Status fmi3SetClock(Instance i) { return unserved(i, "fmi3SetClock"); }
Status fmi3SetInt64(Instance i) { return unserved(i, "fmi3SetInt64"); }

// Capabilities that modelDescription.xml denies.
Status fmi3GetNumberOfVariableDependencies(Instance i) {
  return unserved(i, "fmi3GetNumberOfVariableDependencies");
}
Status fmi3GetVariableDependencies(Instance i) {
  return unserved(i, "fmi3GetVariableDependencies");
}
Status fmi3GetDirectionalDerivative(Instance i) {
  return unserved(i, "fmi3GetDirectionalDerivative");
}
Status fmi3GetAdjointDerivative(Instance i) { return unserved(i, "fmi3GetAdjointDerivative"); }
Status fmi3EnterConfigurationMode(Instance i) { return unserved(i, "fmi3EnterConfigurationMode"); }
Status fmi3ExitConfigurationMode(Instance i) { return unserved(i, "fmi3ExitConfigurationMode"); }
Status fmi3GetIntervalDecimal(Instance i) { return unserved(i, "fmi3GetIntervalDecimal"); }
Status fmi3GetIntervalFraction(Instance i) { return unserved(i, "fmi3GetIntervalFraction"); }
Status fmi3GetShiftDecimal(Instance i) { return unserved(i, "fmi3GetShiftDecimal"); }
Status fmi3GetShiftFraction(Instance i) { return unserved(i, "fmi3GetShiftFraction"); }
Status fmi3SetIntervalDecimal(Instance i) { return unserved(i, "fmi3SetIntervalDecimal"); }
Status fmi3SetIntervalFraction(Instance i) { return unserved(i, "fmi3SetIntervalFraction"); }
Status fmi3SetShiftDecimal(Instance i) { return unserved(i, "fmi3SetShiftDecimal"); }
Status fmi3SetShiftFraction(Instance i) { return unserved(i, "fmi3SetShiftFraction"); }
Status fmi3EvaluateDiscreteStates(Instance i) { return unserved(i, "fmi3EvaluateDiscreteStates"); }
Status fmi3GetOutputDerivatives(Instance i) { return unserved(i, "fmi3GetOutputDerivatives"); }

}  // extern "C"
#pragma GCC visibility pop
