/// The lighting models, in the order of the documentation. NAME stands for the value Model::kNAME
/// and for the type that describes the model, in a header of its own.
#pragma once

#include "models/blinn_phong.h"
#include "models/cook_torrance.h"
#include "models/minnaert.h"
#include "models/oren_nayar.h"
#include "models/phong.h"

#define LUMAKNOT_MODELS(model) \
  model(Phong) model(BlinnPhong) model(Minnaert) model(OrenNayar) model(CookTorrance)
